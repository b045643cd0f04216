// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/map_features.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "sbox/core/digest.h"

namespace sbox {
namespace {

/// The items in an order in which any first n are spread over all of them: steps of the golden
/// ratio round a circle.
template <typename Item>
std::vector<Item> scattered(const std::vector<Item>& items) {
  const size_t count = items.size();
  if (count < 3) {
    return items;
  }
  auto step = static_cast<size_t>(std::lround(static_cast<double>(count) * 0.6180339887));
  while (std::gcd(step, count) != 1) {
    ++step;
  }
  std::vector<Item> result;
  result.reserve(count);
  for (size_t i = 0, at = 0; i < count; ++i, at = (at + step) % count) {
    result.push_back(items[at]);
  }
  return result;
}

/// As many of the items as there may be, evenly spread over all, in their order.
template <typename Item>
void thinOut(std::vector<Item>& items, size_t most) {
  const size_t count = items.size();
  if (count <= most) {
    return;
  }
  for (size_t i = 0; i < most; ++i) {
    items[i] = items[i * count / most];
  }
  items.resize(most);
}

std::vector<Eigen::Vector2d> freePoints(const StateGrid& grid, double spacing) {
  std::vector<Eigen::Vector2d> points;
  const double step = spacing / grid.resolution;
  for (double y = 0.5 * step; y < grid.height; y += step) {
    for (double x = 0.5 * step; x < grid.width; x += step) {
      const int column = static_cast<int>(x), row = static_cast<int>(y);
      if (grid.at(column, row) == CellState::Free) {
        points.emplace_back(Eigen::Vector2d(column + 0.5, row + 0.5) * grid.resolution);
      }
    }
  }
  return scattered(points);
}

std::uint64_t digestOf(const StateGrid& grid) {
  return Digest()
      .add(static_cast<std::uint64_t>(grid.width))
      .add(grid.cells.data(), grid.cells.size())
      .value();
}

Point2D toPoint(const Eigen::Vector2d& point) { return {point.x(), point.y()}; }

/// What the frames hold, in the map frame.
FeatureSet describe(const std::vector<FrameFeatures>& frames, const std::vector<WallLine>& lines,
                    double min_wall_share, const Pose2D& grid_in_map) {
  FeatureSet set;
  const auto in_map = [&](const Eigen::Vector2d& point) {
    return grid_in_map.composePoint(toPoint(point));
  };
  for (const WallLine& line : lines) {
    if (line.wall_share < min_wall_share) {
      continue;  // An edge of the unknown.
    }
    set.lines.push_back({in_map(line.from), in_map(line.to)});
  }
  for (const FrameFeatures& frame : frames) {
    const Eigen::Matrix2d to_grid = Eigen::Rotation2Dd(frame.frame.direction).toRotationMatrix();
    for (const WallCorner& corner : frame.corners) {
      set.vertical_points.push_back(in_map(to_grid * corner.position));
    }
    for (const WallBox& box : frame.boxes) {
      std::array<Point2D, 4>& corners = set.boxes.emplace_back();
      for (size_t i = 0; i < 4; ++i) {
        corners[i] = in_map(to_grid * box.corners[i]);
      }
    }
  }
  return set;
}

}  // namespace

bool comesFirst(const MapFeatures& one, const MapFeatures& other) {
  const auto order = [](const MapFeatures& map) {
    return std::make_tuple(map.digest, map.width, map.height, map.grid_in_map.x, map.grid_in_map.y,
                           map.grid_in_map.phi);
  };
  const auto order_of_one = order(one), order_of_other = order(other);
  if (order_of_one != order_of_other) {
    return order_of_one < order_of_other;
  }
  // What differs in the maps' own cells only shows where walls were sharpened.
  return std::lexicographical_compare(
      one.wall_points.begin(), one.wall_points.end(), other.wall_points.begin(),
      other.wall_points.end(), [](const WallPoint& left, const WallPoint& right) {
        return std::make_pair(left.position.x(), left.position.y()) <
               std::make_pair(right.position.x(), right.position.y());
      });
}

MapFeatures extractFeatures(const Map& map, const FeatureOptions& options) {
  MapFeatures features;
  const StateGrid cells = classifyCells(map, options.states);
  features.resolution = map.resolution();
  features.grid_in_map = cells.corner_in_map;
  if (cells.empty()) {
    return features;
  }
  const bool is_fine = cells.resolution < 0.75 * options.working_resolution;
  // Coarser cells overlap by one of the map's, so that walls of cells that meet at corners, as
  // those of slanted walls do, stay closed.
  const StateGrid grid = is_fine ? resample(cells, options.working_resolution, 1) : cells;
  features.digest = digestOf(grid);
  features.width = grid.width * grid.resolution;
  features.height = grid.height * grid.resolution;

  // Section 3.1.1: wall lines, from the outline of free space. Where it moves at corners, only
  // sharpening brings it back.
  ContourOptions contours = options.contours;
  contours.close_corners = contours.close_corners && is_fine;
  Walls walls = findWalls(traceFreeContours(grid, contours), grid.resolution, options.walls);
  const size_t all_points = walls.points.size();
  thinOut(walls.points, WallFields::most_points);
  if (is_fine) {
    sharpenWalls(cells, walls, options.sharpen);
  }
  features.wall_points = scattered(walls.points);
  for (const WallPoint& point : features.wall_points) {
    features.wall_directions.push_back(toByteAngle(std::atan2(point.normal.y(), point.normal.x())));
  }
  features.point_spacing =
      options.walls.point_spacing * (static_cast<double>(std::max<size_t>(all_points, 1)) /
                                     static_cast<double>(std::max<size_t>(walls.points.size(), 1)));
  const double free_spacing = std::max(
      options.free_spacing, std::sqrt(features.width * features.height / options.most_free_points));
  features.free_points = freePoints(grid, free_spacing);
  features.free_point_area = free_spacing * free_spacing;
  // Vertical points (eq. 1) and boxes (section 3.1.3, eq. 3) along each main direction.
  for (const WallFrame& frame : findFrames(walls.lines, options.frames)) {
    FrameFeatures of_frame;
    of_frame.frame = frame;
    of_frame.lines = linesOfFrame(walls.lines, frame, options.axis_lines);
    of_frame.corners = findCorners(of_frame.lines, options.corners);
    of_frame.boxes = findBoxes(of_frame.lines, options.boxes);
    features.frames.push_back(std::move(of_frame));
  }
  if (!features.frames.empty()) {
    features.slope_spread = slopeSpread(features.frames.front().lines);
  }
  features.fields = makeFields(grid, features.wall_points, options.fields);
  features.feature_set = describe(features.frames, walls.lines, options.axis_lines.min_wall_share,
                                  features.grid_in_map);
  return features;
}

}  // namespace sbox
