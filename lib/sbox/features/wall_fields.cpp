// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/wall_fields.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "sbox/core/round.h"

namespace sbox {
namespace {

/// Calls take(sector) for each that a normal belongs to: its own, and a neighbour if it is near to
/// that.
template <typename Take>
void forEachSector(const Eigen::Vector2d& normal, double overlap, const Take& take) {
  const double turns = std::atan2(normal.y(), normal.x()) / (M_PI / 4);
  const double nearest = std::round(turns), off = turns - nearest;
  const int own = (static_cast<int>(nearest) + kSectors) % kSectors;
  take(static_cast<size_t>(own));
  if (0.5 - std::abs(off) <= overlap / 45) {
    take(static_cast<size_t>((own + (off > 0 ? 1 : kSectors - 1)) % kSectors));
  }
}

/// Offers a wall point to the cells within `radius` cells along rows and columns;
/// `squared_distances` and `nearest` are of the points offered so far.
void offer(const WallFields& fields, const Eigen::Vector2d& position, std::int32_t index,
           double radius, std::vector<float>& squared_distances,
           std::vector<std::int32_t>& nearest) {
  const double column = (position.x() - fields.origin.x()) / fields.resolution - 0.5;
  const double row = (position.y() - fields.origin.y()) / fields.resolution - 0.5;
  const int x_first = std::max(0, ceilToInt(column - radius));
  const int x_last = std::min(fields.width - 1, floorToInt(column + radius));
  const int y_first = std::max(0, ceilToInt(row - radius));
  const int y_last = std::min(fields.height - 1, floorToInt(row + radius));
  for (int y = y_first; y <= y_last; ++y) {
    const auto dy = static_cast<float>(y - row);
    const size_t row_start = static_cast<size_t>(y) * static_cast<size_t>(fields.width);
    float* squared = squared_distances.data() + row_start;
    std::int32_t* indices = nearest.data() + row_start;
    for (int x = x_first; x <= x_last; ++x) {
      const float dx = static_cast<float>(x) - static_cast<float>(column);
      const float d = dx * dx + dy * dy;
      indices[x] = d < squared[x] ? index : indices[x];
      squared[x] = std::min(d, squared[x]);
    }
  }
}

/// A wall point on its way into the field of a sector.
struct Offered {
  std::uint64_t place;  ///< Grows row by row, and along a row, of the field's cells.
  Eigen::Vector2d position;
  std::int32_t index;
};

/// The points that face each sector, row by row: they come scattered, but neighbours one after the
/// other find their cells in the cache.
std::array<std::vector<Offered>, kSectors> bySector(const std::vector<WallPoint>& points,
                                                    double resolution, double overlap) {
  std::array<std::vector<Offered>, kSectors> facing;
  for (size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d& position = points[i].position;
    const auto row = static_cast<std::uint32_t>(floorToInt(position.y() / resolution));
    const auto column = static_cast<std::uint32_t>(floorToInt(position.x() / resolution));
    forEachSector(points[i].normal, overlap, [&](size_t sector) {
      facing[sector].push_back(
          {std::uint64_t{row} << 32 | column, position, static_cast<std::int32_t>(i)});
    });
  }
  for (std::vector<Offered>& offered : facing) {
    std::sort(offered.begin(), offered.end(), [](const Offered& left, const Offered& right) {
      return std::tie(left.place, left.index) < std::tie(right.place, right.index);
    });
  }
  return facing;
}

/// Distances in cells from the cells of the rows `first` to `last` to the nearest cell there that
/// is not free. Row -1 and the row above the grid, and column 0 and the last, are a rim that is not
/// free, so that the edge of the grid counts.
cv::Mat depthInRows(const StateGrid& grid, int first, int last) {
  cv::Mat free(last - first + 1, grid.width + 2, CV_8U, cv::Scalar(0));
  for (int y = std::max(first, 0); y <= std::min(last, grid.height - 1); ++y) {
    auto* pixel = free.ptr<unsigned char>(y - first) + 1;
    const CellState* cell =
        grid.cells.data() + static_cast<size_t>(y) * static_cast<size_t>(grid.width);
    for (int x = 0; x < grid.width; ++x) {
      pixel[x] = cell[x] == CellState::Free ? 255 : 0;
    }
  }
  cv::Mat depth;
  cv::distanceTransform(free, depth, cv::DIST_L2, 3);
  return depth;
}

/// Index of the grid's row or column that holds the centre of the i-th of the fields.
int gridIndex(double origin, int i, const WallFields& fields, const StateGrid& grid) {
  return floorToInt((origin + (i + 0.5) * fields.resolution) / grid.resolution);
}

void fillDepth(const StateGrid& grid, WallFields& fields) {
  // Band by band, to need little memory at once: nothing further off than a margin matters.
  constexpr int band = 512;
  // The chamfer distance counts 0.955 for a row.
  const int margin = ceilToInt(WallFields::far * WallFields::unit / (0.95 * grid.resolution)) + 1;
  std::vector<int> columns;
  for (int x = 0; x < fields.width; ++x) {
    columns.push_back(gridIndex(fields.origin.x(), x, fields, grid));
  }
  int y = 0;
  for (int first = 0; first < grid.height; first += band) {
    const int first_row = std::max(first - margin, -1);
    const cv::Mat depth =
        depthInRows(grid, first_row, std::min(first + band + margin, grid.height));
    for (; y < fields.height; ++y) {
      const int row = gridIndex(fields.origin.y(), y, fields, grid);
      if (row < 0) {
        continue;
      }
      if (row >= std::min(first + band, grid.height)) {
        break;
      }
      const auto* distance = depth.ptr<float>(row - first_row) + 1;
      std::uint8_t* field_row =
          fields.free_depth.data() + static_cast<size_t>(y) * static_cast<size_t>(fields.width);
      for (int x = 0; x < fields.width; ++x) {
        const int column = columns[static_cast<size_t>(x)];
        if (column >= 0 && column < grid.width) {
          const double metres = static_cast<double>(distance[column]) * grid.resolution;
          field_row[x] =
              static_cast<std::uint8_t>(std::min(255.0, metres / WallFields::unit + 0.5));
        }
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
  fields.free_depth.assign(count, 0);
  fillDepth(grid, fields);

  const auto facing = bySector(points, fields.resolution, options.sector_overlap);
  const double radius = options.reach / fields.resolution;
  // What lies further off is no nearer than nothing.
  const auto nothing = static_cast<float>(radius * radius);
  const auto to_units = static_cast<float>(fields.resolution / WallFields::unit);
  std::vector<float> squared;
  for (size_t sector = 0; sector < kSectors; ++sector) {
    std::vector<std::int32_t>& nearest = fields.nearest[sector];
    squared.assign(count, nothing);
    nearest.assign(count, -1);
    for (const Offered& point : facing[sector]) {
      offer(fields, point.position, point.index, radius, squared, nearest);
    }
    std::vector<std::uint8_t>& distances = fields.distances[sector];
    distances.resize(count);
    std::transform(squared.begin(), squared.end(), distances.begin(), [to_units](float square) {
      return static_cast<std::uint8_t>(std::min(255.F, std::sqrt(square) * to_units + 0.5F));
    });
    std::transform(nearest.begin(), nearest.end(), distances.begin(), distances.begin(),
                   [](std::int32_t index, std::uint8_t distance) {
                     return index >= 0 ? distance : std::uint8_t{WallFields::far};
                   });
  }
  return fields;
}

}  // namespace sbox
