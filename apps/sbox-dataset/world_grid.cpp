// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/world_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbox::dataset {
namespace {

constexpr float kOccupied = 0.02F;
constexpr float kFree = 0.98F;

/// Marks the cells that a segment runs through, by a walk from one cell border to the next.
void drawSegment(mrpt::maps::COccupancyGridMap2D& grid, const LineSegment& wall) {
  int x = grid.x2idx(wall.from.x), y = grid.y2idx(wall.from.y);
  const int x_end = grid.x2idx(wall.to.x), y_end = grid.y2idx(wall.to.y);
  const Point2D along = wall.to - wall.from;
  const int step_x = along.x > 0 ? 1 : -1, step_y = along.y > 0 ? 1 : -1;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double cell = grid.getResolution();
  // Share of the segment at which it crosses the next border of a column or row.
  double next_x =
      along.x == 0 ? kNever : (grid.idx2x(x) + step_x * cell / 2 - wall.from.x) / along.x;
  double next_y =
      along.y == 0 ? kNever : (grid.idx2y(y) + step_y * cell / 2 - wall.from.y) / along.y;
  for (int left = std::abs(x_end - x) + std::abs(y_end - y); left >= 0; --left) {
    grid.setCell(x, y, kOccupied);
    if (next_x < next_y) {
      next_x += cell / std::abs(along.x);
      x += step_x;
    } else {
      next_y += cell / std::abs(along.y);
      y += step_y;
    }
  }
}

}  // namespace

mrpt::maps::COccupancyGridMap2D worldGrid(const World& world, double resolution, double margin) {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  bool first = true;
  for (const LineSegment& wall : world.walls) {
    for (const Point2D& end : {wall.from, wall.to}) {
      x_min = first ? end.x : std::min(x_min, end.x);
      x_max = first ? end.x : std::max(x_max, end.x);
      y_min = first ? end.y : std::min(y_min, end.y);
      y_max = first ? end.y : std::max(y_max, end.y);
      first = false;
    }
  }
  mrpt::maps::COccupancyGridMap2D grid(
      static_cast<float>(x_min - margin), static_cast<float>(x_max + margin),
      static_cast<float>(y_min - margin), static_cast<float>(y_max + margin),
      static_cast<float>(resolution));
  grid.fill(kFree);
  for (const LineSegment& wall : world.walls) {
    drawSegment(grid, wall);
  }
  return grid;
}

}  // namespace sbox::dataset
