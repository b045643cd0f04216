// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/features/free_contours.h"
#include "sbox/features/sharpen_walls.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

constexpr double fine = 0.05, coarse = 0.1;

/// Free space in the rectangle, walls round it, in fine cells.
StateGrid room(int x_low, int x_high, int y_low, int y_high) {
  StateGrid grid = test::freeGrid(120, 90, fine);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (x < x_low || x >= x_high || y < y_low || y >= y_high) {
        grid.cells[static_cast<size_t>(y) * static_cast<size_t>(grid.width) +
                   static_cast<size_t>(x)] = CellState::Occupied;
      }
    }
  }
  return grid;
}

/// The walls as they are found in coarse cells.
Walls coarseWalls(const StateGrid& cells) {
  return findWalls(traceFreeContours(resample(cells, coarse)), coarse);
}

/// Distance of a point from the nearest side of the rectangle from `low` to `high`.
double fromSide(const Vector2d& p, const Vector2d& low, const Vector2d& high) {
  return std::min({std::abs(p.x() - low.x()), std::abs(p.x() - high.x()), std::abs(p.y() - low.y()),
                   std::abs(p.y() - high.y())});
}

}  // namespace

TEST_CASE("walls move to the edge of free space in the map's own cells", "[features]") {
  // Odd cells: the edges lie in the middle of coarse cells.
  const StateGrid cells = room(11, 101, 9, 71);
  const Vector2d low(11 * fine, 9 * fine), high(101 * fine, 71 * fine);
  Walls walls = coarseWalls(cells);
  REQUIRE(walls.lines.size() == 4);
  double before = 0;
  for (const WallLine& line : walls.lines) {
    before = std::max(before, fromSide((line.from + line.to) / 2, low, high));
  }
  CHECK(before == Approx(fine));
  sharpenWalls(cells, walls);
  for (const WallLine& line : walls.lines) {
    CHECK(fromSide((line.from + line.to) / 2, low, high) < 0.01);
    CHECK(std::abs(line.direction().x() * line.direction().y()) < 0.005);
  }
  for (const WallPoint& point : walls.points) {
    CHECK(fromSide(point.position, low, high) < 0.01);
  }
}

TEST_CASE("an oblique wall is found to a fraction of a cell", "[features]") {
  const double angle = 0.3;
  const Vector2d normal(-std::sin(angle), std::cos(angle)), on_line(3, 2.013);
  StateGrid cells = test::freeGrid(120, 90, fine);
  for (int y = 0; y < cells.height; ++y) {
    for (int x = 0; x < cells.width; ++x) {
      if (normal.dot(Vector2d(x + 0.5, y + 0.5) * fine - on_line) < 0) {
        cells.cells[static_cast<size_t>(y) * static_cast<size_t>(cells.width) +
                    static_cast<size_t>(x)] = CellState::Occupied;
      }
    }
  }
  Walls walls = coarseWalls(cells);
  const auto errorOf = [&] {
    double sum = 0;
    int count = 0;
    for (const WallPoint& point : walls.points) {
      if (point.normal.dot(normal) > 0.99) {
        sum += normal.dot(point.position - on_line);
        ++count;
      }
    }
    REQUIRE(count > 10);
    return std::abs(sum / count);
  };
  const double before = errorOf();
  sharpenWalls(cells, walls);
  CHECK(errorOf() < 0.3 * fine);
  CHECK(errorOf() < before);
}

TEST_CASE("a wall without an edge within reach stays where it was", "[features]") {
  const StateGrid cells = test::freeGrid(120, 90, fine);
  Walls walls;
  walls.lines.push_back({{1, 1}, {4, 1}, 1});
  walls.points.push_back({{2, 1}, {0, 1}});
  sharpenWalls(cells, walls);
  CHECK(walls.lines[0].from == Vector2d(1, 1));
  CHECK(walls.lines[0].to == Vector2d(4, 1));
  CHECK(walls.points[0].position == Vector2d(2, 1));
}
