// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/wall_fields.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <tuple>

namespace sbox {
namespace {

/// Squared distances to, and indices of, the nearest wall points of one sector.
struct SectorField {
  std::vector<float> squared;
  std::vector<std::int32_t> index;
};

/// Sectors that a normal belongs to: its own, and a neighbour if it is near to that.
std::vector<int> sectorsOf(const Eigen::Vector2d& normal, double overlap) {
  const double turns = std::atan2(normal.y(), normal.x()) / (M_PI / 4);
  const double nearest = std::round(turns), off = turns - nearest;
  const int own = (static_cast<int>(nearest) + kSectors) % kSectors;
  std::vector<int> sectors{own};
  if (0.5 - std::abs(off) <= overlap / 45) {
    sectors.push_back((own + (off > 0 ? 1 : kSectors - 1)) % kSectors);
  }
  return sectors;
}

/// Offers a wall point to all cells within reach.
void offer(const WallFields& fields, const Eigen::Vector2d& position, std::int32_t index,
           double reach, SectorField& field) {
  const double column = (position.x() - fields.origin.x()) / fields.resolution - 0.5;
  const double row = (position.y() - fields.origin.y()) / fields.resolution - 0.5;
  const double radius = reach / fields.resolution;
  const int y_first = std::max(0, static_cast<int>(std::ceil(row - radius)));
  const int y_last = std::min(fields.height - 1, static_cast<int>(std::floor(row + radius)));
  for (int y = y_first; y <= y_last; ++y) {
    const auto dy = static_cast<float>(y - row);
    const double half = std::sqrt(std::max(0.0, radius * radius - static_cast<double>(dy) * dy));
    const int x_first = std::max(0, static_cast<int>(std::ceil(column - half)));
    const int x_last = std::min(fields.width - 1, static_cast<int>(std::floor(column + half)));
    const size_t row_start = static_cast<size_t>(y) * static_cast<size_t>(fields.width);
    float* squared = field.squared.data() + row_start;
    std::int32_t* indices = field.index.data() + row_start;
    for (int x = x_first; x <= x_last; ++x) {
      const float dx = static_cast<float>(x) - static_cast<float>(column);
      const float d = dx * dx + dy * dy;
      indices[x] = d < squared[x] ? index : indices[x];
      squared[x] = std::min(d, squared[x]);
    }
  }
}

/// The points' indices, cell row by cell row: they come scattered, but neighbours one after the
/// other find their cells in the cache.
std::vector<size_t> rowByRow(const std::vector<WallPoint>& points, double resolution) {
  std::vector<std::tuple<double, double, size_t>> places;
  places.reserve(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d& p = points[i].position;
    places.emplace_back(std::floor(p.y() / resolution), p.x(), i);
  }
  std::sort(places.begin(), places.end());
  std::vector<size_t> indices;
  indices.reserve(points.size());
  for (const auto& place : places) {
    indices.push_back(std::get<2>(place));
  }
  return indices;
}

void fillDepth(const StateGrid& grid, WallFields& fields) {
  // A rim of one cell that is not free, so that the edge of the grid counts.
  cv::Mat free(grid.height + 2, grid.width + 2, CV_8U, cv::Scalar(0));
  for (int y = 0; y < grid.height; ++y) {
    auto* pixel = free.ptr<unsigned char>(y + 1) + 1;
    for (int x = 0; x < grid.width; ++x) {
      pixel[x] = grid.at(x, y) == CellState::Free ? 255 : 0;
    }
  }
  cv::Mat depth;
  cv::distanceTransform(free, depth, cv::DIST_L2, 3);
  for (int y = 0; y < fields.height; ++y) {
    for (int x = 0; x < fields.width; ++x) {
      const double px = fields.origin.x() + (x + 0.5) * fields.resolution;
      const double py = fields.origin.y() + (y + 0.5) * fields.resolution;
      const int column = static_cast<int>(std::floor(px / grid.resolution)) + 1;
      const int row = static_cast<int>(std::floor(py / grid.resolution)) + 1;
      if (column > 0 && row > 0 && column <= grid.width && row <= grid.height) {
        const double metres = static_cast<double>(depth.at<float>(row, column)) * grid.resolution;
        fields.free_depth[static_cast<size_t>(y) * static_cast<size_t>(fields.width) +
                          static_cast<size_t>(x)] =
            static_cast<std::uint8_t>(std::min(255.0, std::round(metres / WallFields::unit)));
      }
    }
  }
}

}  // namespace

ByteAngle toByteAngle(double radians) {
  return static_cast<ByteAngle>(static_cast<int>(std::lround(radians / (2 * M_PI) * 256)) & 0xFF);
}

WallFields makeFields(const StateGrid& grid, const std::vector<WallPoint>& points,
                      const FieldOptions& options) {
  WallFields fields;
  fields.resolution = options.resolution;
  if (grid.empty()) {
    return fields;
  }
  const double area = grid.resolution * grid.resolution * grid.width * grid.height;
  fields.resolution = std::max(options.resolution, std::sqrt(area / options.most_cells));
  fields.origin = Eigen::Vector2d::Constant(-options.reach);
  const auto cells = [&](int size) {
    return static_cast<int>(
        std::ceil((size * grid.resolution + 2 * options.reach) / fields.resolution));
  };
  fields.width = cells(grid.width);
  fields.height = cells(grid.height);
  const size_t count = static_cast<size_t>(fields.width) * static_cast<size_t>(fields.height);
  fields.distances.assign(count, ~std::uint64_t{0});
  fields.nearest.assign(count * kSectors, -1);
  fields.free_depth.assign(count, 0);
  fillDepth(grid, fields);

  std::array<std::vector<std::int32_t>, kSectors> facing;
  for (const size_t i : rowByRow(points, fields.resolution)) {
    for (const int sector : sectorsOf(points[i].normal, options.sector_overlap)) {
      facing[static_cast<size_t>(sector)].push_back(static_cast<std::int32_t>(i));
    }
  }
  const float nothing = 1e9F;
  SectorField field;
  for (size_t sector = 0; sector < kSectors; ++sector) {
    field.squared.assign(count, nothing);
    field.index.assign(count, -1);
    for (const std::int32_t index : facing[sector]) {
      offer(fields, points[static_cast<size_t>(index)].position, index, options.reach, field);
    }
    const auto to_units = static_cast<float>(fields.resolution / WallFields::unit);
    for (size_t cell = 0; cell < count; ++cell) {
      if (field.index[cell] < 0) {
        continue;
      }
      const float distance = std::min(255.F, std::sqrt(field.squared[cell]) * to_units + 0.5F);
      // The byte is all ones so far.
      fields.distances[cell] ^= (255 - static_cast<std::uint64_t>(distance)) << (8 * sector);
      fields.nearest[cell * kSectors + sector] = field.index[cell];
    }
  }
  return fields;
}

}  // namespace sbox
