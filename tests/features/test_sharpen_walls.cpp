// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

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

/// Where free space ends on the line through `base`, step by step.
std::optional<double> edgeOf(const StateGrid& cells, const Vector2d& base, const Vector2d& normal) {
  const double reach = SharpenOptions().reach, step = cells.resolution / 4;
  bool was_free = false;
  for (double offset = reach; offset >= -reach; offset -= step) {
    // Rounded as there: on the edge of a cell that decides.
    const Vector2d cell = base / cells.resolution + offset / cells.resolution * normal;
    const bool is_free = cells.at(static_cast<int>(std::floor(cell.x())),
                                  static_cast<int>(std::floor(cell.y()))) == CellState::Free;
    if (was_free && !is_free) {
      return offset + step / 2;
    }
    was_free = is_free;
  }
  return std::nullopt;
}

/// The mean of the edges along the wall at a point, but for those far from their median.
Vector2d sharpened(const StateGrid& cells, const WallPoint& point) {
  const SharpenOptions options;
  const Vector2d along(point.normal.y(), -point.normal.x());
  std::vector<double> edges;
  for (double place = -options.along; place <= options.along; place += 2 * cells.resolution) {
    if (const auto edge = edgeOf(cells, point.position + place * along, point.normal)) {
      edges.push_back(*edge);
    }
  }
  if (edges.empty()) {
    return point.position;
  }
  std::vector<double> sorted = edges;
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted[sorted.size() / 2];
  double sum = 0, count = 0;
  for (const double edge : edges) {
    if (std::abs(edge - median) <= std::max(options.outlier, 1.5 * cells.resolution)) {
      sum += edge;
      ++count;
    }
  }
  return point.position + sum / count * point.normal;
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

TEST_CASE("edges are those that a walk in steps of a quarter cell finds", "[features]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(-0.2, 6.2), y(-0.2, 4.7), angle(0, 2 * M_PI);
  StateGrid cells = test::freeGrid(120, 90, fine);
  for (CellState& cell : cells.cells) {
    cell = random() % 3 == 0 ? CellState::Occupied : CellState::Free;
  }
  Walls walls;
  for (int i = 0; i < 4000; ++i) {
    // Half of them square to the cells, and half of these on the cells' own edges.
    const double facing = i % 2 == 0 ? angle(random) : std::round(angle(random)) * M_PI / 2;
    const double grain = i % 4 == 1 ? fine : 1e-9;
    const Vector2d place(std::round(x(random) / grain) * grain,
                         std::round(y(random) / grain) * grain);
    walls.points.push_back({place, {std::cos(facing), std::sin(facing)}});
  }
  const std::vector<WallPoint> before = walls.points;
  sharpenWalls(cells, walls);
  int moved = 0, wrong = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    moved += walls.points[i].position != before[i].position ? 1 : 0;
    wrong += walls.points[i].position == sharpened(cells, before[i]) ? 0 : 1;
  }
  CHECK(moved > 3000);
  CHECK(wrong == 0);
}
