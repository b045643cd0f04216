// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ways for robots through the free space of a world: Dijkstra's shortest paths on a grid that keep
// clear of walls, and tours that visit places.
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <vector>

#include "sbox-dataset/drive.h"

namespace sbox::dataset {

struct RouteOptions {
  double radius = 0.2;      ///< No way passes a wall more closely, metres.
  double keep_clear = 0.6;  ///< Ways that pass a wall more closely are avoided where others are, m.
};

/// The distance from each cell to the nearest wall, which routes are planned with.
class RoutePlanner {
 public:
  /// Keeps a copy of what it needs of the grid, in which walls are occupied.
  explicit RoutePlanner(const mrpt::maps::COccupancyGridMap2D& grid,
                        const RouteOptions& options = {});

  /// Corner points of a way from `from` to `to`, without `from`; empty if there is none or either
  /// end is too close to a wall.
  [[nodiscard]] std::vector<Point2D> route(const Point2D& from, const Point2D& to) const;

  /// A path from start to each place in turn. Places that cannot be reached are left out.
  [[nodiscard]] Path tour(const Pose2D& start_in_world, const std::vector<Point2D>& places) const;

 private:
  [[nodiscard]] int cellAt(const Point2D& point) const;
  [[nodiscard]] Point2D centreOf(int cell) const;
  [[nodiscard]] bool seesStraight(const Point2D& from, const Point2D& to) const;

  RouteOptions options_;
  int width_;
  int height_;
  double resolution_;
  Point2D corner_;
  std::vector<float> clearance_;  ///< Metres to the nearest wall, cell by cell.
};

}  // namespace sbox::dataset
