// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/features/wall_lines.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

Walls wallsOf(const StateGrid& grid, const WallLineOptions& options = {}) {
  return findWalls(traceFreeContours(grid), grid.resolution, options);
}

/// A room of 6 m x 4 m, its lower-left corner at (1, 0.5) of the grid.
StateGrid room(double resolution) {
  const auto cells = [&](double metres) {
    return static_cast<int>(std::lround(metres / resolution));
  };
  StateGrid grid = test::freeGrid(cells(8), cells(5), resolution);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (x < cells(1) || x >= cells(7) || y < cells(0.5) || y >= cells(4.5)) {
        grid.cells[static_cast<size_t>(y) * static_cast<size_t>(grid.width) +
                   static_cast<size_t>(x)] = CellState::Occupied;
      }
    }
  }
  return grid;
}

double distance(const WallLine& line, const Vector2d& point) {
  return std::abs(line.normal().dot(point - line.from));
}

Vector2d vector(const Point2D& p) { return {p.x, p.y}; }

}  // namespace

TEST_CASE("a room has four lines on the faces of its walls", "[features]") {
  for (const double resolution : {0.05, 0.1, 0.25}) {
    INFO("cells of " << resolution << " m");
    const Walls walls = wallsOf(room(resolution));
    REQUIRE(walls.lines.size() == 4);
    double turned = 0;
    for (size_t i = 0; i < 4; ++i) {
      const WallLine& line = walls.lines[i];
      const Vector2d middle = (line.from + line.to) / 2;
      // The middle of each side of the room, to within rounding.
      const Vector2d off = middle - Vector2d(4, 2.5);
      CHECK((off.isApprox(-3 * line.normal()) || off.isApprox(-2 * line.normal())));
      CHECK(line.length() == Approx(std::abs(off.x()) > 1 ? 4 : 6).margin(1.01 * resolution));
      CHECK(line.wall_share == 1);
      const Vector2d next = walls.lines[(i + 1) % 4].direction();
      turned += std::atan2(line.direction().x() * next.y() - line.direction().y() * next.x(),
                           line.direction().dot(next));
    }
    CHECK(turned == Approx(2 * M_PI));
  }
}

TEST_CASE("lines follow the walls of a room that lies anywhere at any angle", "[features]") {
  for (int degrees = 0; degrees < 90; degrees += 9) {
    const Pose2D map_in_world(3, -2, degrees * M_PI / 180);
    const StateGrid grid =
        classifyCells(test::exploreMap(test::roomFloor(6, 4), map_in_world, 0.1));
    const Walls walls = wallsOf(grid);
    INFO(degrees << " degrees");
    std::array<double, 4> length{};
    for (const WallLine& line : walls.lines) {
      if (line.length() < 1) {
        continue;  // The steps of the cells may cut a piece off the end of a side.
      }
      const auto inWorld = [&](const Vector2d& p) {
        return vector(map_in_world.composePoint(grid.corner_in_map.composePoint({p.x(), p.y()})));
      };
      const Vector2d from = inWorld(line.from), to = inWorld(line.to);
      // Which side of the room it is, by the way it faces, and that it lies on that.
      const double facing = std::atan2(to.y() - from.y(), to.x() - from.x()) / (M_PI / 2);
      const auto side = static_cast<size_t>(std::lround(facing) + 4) % 4;
      CHECK(std::abs(facing - std::round(facing)) * 90 < 2);
      const std::array<double, 4> walls_at{0, 6, 4, 0};
      for (const Vector2d& end : {from, to}) {
        CHECK(end[side % 2 == 0 ? 1 : 0] == Approx(walls_at[side]).margin(0.15));
      }
      length[side] += (to - from).norm();
    }
    for (size_t side = 0; side < 4; ++side) {
      CHECK(length[side] == Approx(side % 2 == 0 ? 6 : 4).margin(0.7));
    }
  }
}

TEST_CASE("wall points are evenly spaced on the lines", "[features]") {
  const Walls walls = wallsOf(room(0.1));
  CHECK(static_cast<double>(walls.points.size()) * 0.2 == Approx(20).margin(0.7));
  double normals_inward = 0;
  for (const WallPoint& point : walls.points) {
    double nearest = 1e9, length = 0;
    for (const WallLine& line : walls.lines) {
      if (line.normal().isApprox(point.normal) && distance(line, point.position) < nearest) {
        nearest = distance(line, point.position);
        length = line.length();
      }
    }
    CHECK(nearest < 1e-9);
    CHECK(point.line_length == length);
    normals_inward += point.normal.dot(Vector2d(4, 2.5) - point.position) > 0 ? 1 : 0;
  }
  CHECK(normals_inward == static_cast<double>(walls.points.size()));
}

TEST_CASE("the edge of the unknown has a line but no wall", "[features]") {
  StateGrid grid = room(0.1);
  // What lies beyond x = 4 m was not seen.
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 40; x < grid.width; ++x) {
      grid.cells[static_cast<size_t>(y) * static_cast<size_t>(grid.width) +
                 static_cast<size_t>(x)] = CellState::Unknown;
    }
  }
  const Walls walls = wallsOf(grid);
  REQUIRE(walls.lines.size() == 4);
  int open = 0;
  for (const WallLine& line : walls.lines) {
    if (line.normal().x() < -0.9) {
      ++open;
      CHECK(line.from.x() == Approx(4));
      CHECK(line.wall_share < 0.2);
    } else {
      CHECK(line.wall_share == 1);
    }
  }
  CHECK(open == 1);
  for (const WallPoint& point : walls.points) {
    // But for where the neighbouring walls end.
    CHECK((point.position.x() < 3.95 || std::abs(point.position.y() - 2.5) > 1.7));
  }
}

TEST_CASE("points on a round wall face its middle", "[features]") {
  StateGrid grid = test::freeGrid(100, 100, 0.1);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      if (std::hypot(x + 0.5 - 50, y + 0.5 - 50) > 40) {
        grid.cells[static_cast<size_t>(y) * 100 + static_cast<size_t>(x)] = CellState::Occupied;
      }
    }
  }
  const Walls walls = wallsOf(grid);
  CHECK(static_cast<double>(walls.points.size()) * 0.2 == Approx(2 * M_PI * 4).epsilon(0.1));
  for (const WallPoint& point : walls.points) {
    const Vector2d inward = Vector2d(5, 5) - point.position;
    CHECK(inward.norm() == Approx(4).margin(0.2));
    CHECK(point.normal.dot(inward.normalized()) > std::cos(25 * M_PI / 180));
  }
}

TEST_CASE("short stretches are no lines", "[features]") {
  WallLineOptions options;
  options.min_length = 4.5;
  const Walls walls = wallsOf(room(0.1), options);
  REQUIRE(walls.lines.size() == 2);
  CHECK(std::abs(walls.lines[0].normal().y()) == Approx(1));
  // Their points stay.
  CHECK(walls.points.size() == wallsOf(room(0.1)).points.size());
  for (const WallPoint& point : walls.points) {
    CHECK((point.line_length == 0) == (std::abs(point.normal.x()) > 0.5));
  }
}

TEST_CASE("no outlines have no lines and no points", "[features]") {
  const Walls walls = findWalls({}, 0.1);
  CHECK(walls.lines.empty());
  CHECK(walls.points.empty());
}
