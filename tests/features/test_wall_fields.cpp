// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <random>

#include "catch.h"
#include "drawing.h"
#include "sbox/features/wall_fields.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

Vector2d centreOf(const WallFields& fields, int column, int row) {
  return fields.origin + Vector2d(column + 0.5, row + 0.5) * fields.resolution;
}

size_t indexOf(const WallFields& fields, int column, int row) {
  return static_cast<size_t>(row) * static_cast<size_t>(fields.width) + static_cast<size_t>(column);
}

double distanceIn(const WallFields& fields, size_t cell, size_t sector) {
  return fields.distances[sector][cell] * WallFields::unit;
}

/// Points anywhere near a grid of 8 m x 6 m whose normals are not at the edge of any sector.
std::vector<WallPoint> randomPoints(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(0, 8), y(0, 6), angle(0, 2 * M_PI);
  std::vector<WallPoint> points;
  while (static_cast<int>(points.size()) < count) {
    const double facing = angle(random);
    // Sectors end 22.5 degrees from their middle, or 12 degrees further out.
    const double off = std::abs(std::remainder(facing * 180 / M_PI, 45));
    if (std::abs(off - 10.5) > 1 && off < 21.5) {
      points.push_back({{x(random), y(random)}, {std::cos(facing), std::sin(facing)}});
    }
  }
  return points;
}

}  // namespace

TEST_CASE("directions in bytes wrap round, and fall into eight sectors", "[features]") {
  CHECK(toByteAngle(0) == 0);
  CHECK(toByteAngle(M_PI / 2) == 64);
  CHECK(toByteAngle(-M_PI / 2) == 192);
  CHECK(toByteAngle(5 * M_PI) == 128);
  CHECK(static_cast<ByteAngle>(toByteAngle(3.0) + toByteAngle(4.0)) == toByteAngle(7.0));
  for (size_t sector = 0; sector < kSectors; ++sector) {
    for (const double off : {-22.0, 0.0, 21.0}) {
      const double degrees = static_cast<double>(sector) * 45 + off;
      CHECK(sectorOf(toByteAngle(degrees * M_PI / 180)) == sector);
    }
  }
}

TEST_CASE("a cell is found by a point in it, and none outside", "[features]") {
  WallFields fields;
  fields.width = 5;
  fields.height = 3;
  fields.resolution = 0.2;
  fields.origin = Vector2d(-1, 2);
  CHECK(fields.cellAt(-0.99, 2.01) == 0);
  CHECK(fields.cellAt(-0.01, 2.59) == 14);
  CHECK(fields.cellAt(-0.79, 2.21) == 6);
  CHECK(fields.cellAt(-1.01, 2.1) == -1);
  CHECK(fields.cellAt(0.01, 2.1) == -1);
  CHECK(fields.cellAt(-0.5, 2.61) == -1);
  CHECK(fields.cellAt(-0.5, 1.99) == -1);
  CHECK(fields.cellAt(std::numeric_limits<double>::quiet_NaN(), 2.1) == -1);
  CHECK(fields.cellAt(-0.5, std::numeric_limits<double>::infinity()) == -1);
}

TEST_CASE("fields hold the nearest wall point that faces each way", "[features]") {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto points = randomPoints(60, seed);
    const WallFields fields = makeFields(test::freeGrid(80, 60, 0.1), points);
    int with_wall = 0, without = 0, wrong_distance = 0, wrong_index = 0;
    for (int row = 0; row < fields.height; ++row) {
      for (int column = 0; column < fields.width; ++column) {
        const Vector2d place = centreOf(fields, column, row);
        const size_t cell = indexOf(fields, column, row);
        for (size_t sector = 0; sector < kSectors; ++sector) {
          const double middle = static_cast<double>(sector) * M_PI / 4;
          double nearest = 1e9;
          for (const WallPoint& point : points) {
            const double off = std::acos(std::clamp(
                point.normal.dot(Vector2d(std::cos(middle), std::sin(middle))), -1., 1.));
            if (off < (22.5 + 12) * M_PI / 180) {
              nearest = std::min(nearest, (point.position - place).norm());
            }
          }
          if (std::abs(nearest - 2) < 0.01) {
            continue;  // Just within reach or just not.
          }
          const std::uint16_t index = fields.nearest[sector][cell];
          if (nearest > 2) {
            ++without;
            wrong_distance += distanceIn(fields, cell, sector) > 2.545 ? 0 : 1;
            wrong_index += index == WallFields::none ? 0 : 1;
          } else {
            ++with_wall;
            wrong_distance += std::abs(distanceIn(fields, cell, sector) - nearest) < 0.006 ? 0 : 1;
            wrong_index += index != WallFields::none &&
                                   (points[index].position - place).norm() < nearest + 1e-4
                               ? 0
                               : 1;
          }
        }
      }
    }
    INFO("seed " << seed);
    CHECK(with_wall > 1000);
    CHECK(without > 1000);
    CHECK(wrong_distance == 0);
    CHECK(wrong_index == 0);
  }
}

TEST_CASE("depth in free space is the distance to what is not free", "[features]") {
  StateGrid grid = test::freeGrid(80, 60, 0.1);
  test::drawWall(grid, {{1, 1}, {7, 2}});
  test::drawWall(grid, {{3, 5}, {3, 5.5}});
  for (size_t x = 60; x < 80; ++x) {
    grid.cells[40 * 80 + x] = CellState::Unknown;
  }
  const WallFields fields = makeFields(grid, {});
  int wrong = 0, deep = 0;
  for (int row = 0; row < fields.height; ++row) {
    for (int column = 0; column < fields.width; ++column) {
      const Vector2d place = centreOf(fields, column, row);
      // The grid's cell that holds the place; its edge counts as not free.
      const int cx = static_cast<int>(std::floor(place.x() / 0.1));
      const int cy = static_cast<int>(std::floor(place.y() / 0.1));
      double nearest = 1e9;
      for (int y = -1; y <= grid.height; ++y) {
        for (int x = -1; x <= grid.width; ++x) {
          if (grid.at(x, y) != CellState::Free) {
            nearest = std::min(nearest, 0.1 * std::hypot(x - cx, y - cy));
          }
        }
      }
      if (grid.at(cx, cy) != CellState::Free) {
        nearest = 0;
      }
      const double depth = fields.free_depth[indexOf(fields, column, row)] * WallFields::depth_unit;
      deep += nearest > 1 ? 1 : 0;
      // Distances are counted along straight and diagonal steps: 5 % off at most.
      wrong += std::abs(depth - nearest) <= 0.05 * nearest + 0.0085 ? 0 : 1;
    }
  }
  CHECK(deep > 100);
  CHECK(wrong == 0);
}

TEST_CASE("depth that is worked out by bands is that of the whole grid", "[features]") {
  // Walls so far apart that most of the free space is as deep as can be told, over three bands.
  StateGrid grid = test::freeGrid(150, 1300, 0.1);
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    grid.cells[random() % grid.cells.size()] = CellState::Occupied;
  }
  const WallFields fields = makeFields(grid, {});
  cv::Mat free(grid.height + 2, grid.width + 2, CV_8U, cv::Scalar(0)), depth;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      free.at<unsigned char>(y + 1, x + 1) = grid.at(x, y) == CellState::Free ? 255 : 0;
    }
  }
  cv::distanceTransform(free, depth, cv::DIST_L2, 3);
  int deepest = 0, wrong = 0;
  for (int row = 0; row < fields.height; ++row) {
    for (int column = 0; column < fields.width; ++column) {
      const Vector2d place = centreOf(fields, column, row) / grid.resolution;
      const int x = static_cast<int>(std::floor(place.x()));
      const int y = static_cast<int>(std::floor(place.y()));
      const bool inside = x >= 0 && y >= 0 && x < grid.width && y < grid.height;
      const double metres =
          inside ? static_cast<double>(depth.at<float>(y + 1, x + 1)) * grid.resolution : 0;
      const double expected = std::min(255.0, metres / WallFields::depth_unit);
      const int found = fields.free_depth[indexOf(fields, column, row)];
      deepest += found == 255 ? 1 : 0;
      // Rounded, of steps across corners that count 1.369 cells here and 1.3693 there.
      wrong += std::abs(found - expected) < 0.6 ? 0 : 1;
    }
  }
  CHECK(deepest > 1000);
  CHECK(wrong == 0);
}

TEST_CASE("fields reach beyond the grid, and there are none of nothing", "[features]") {
  const WallFields fields = makeFields(test::freeGrid(80, 60, 0.1), {{{0.1, 3}, {1, 0}}});
  const std::ptrdiff_t outside = fields.cellAt(-1.1, 3.1);
  REQUIRE(outside >= 0);
  CHECK(fields.nearest[0][static_cast<size_t>(outside)] == 0);
  CHECK(fields.free_depth[static_cast<size_t>(outside)] == 0);
  CHECK(fields.depthAt({4, 3}) > 0);
  CHECK(fields.depthAt({-50, 3}) == 0);
  const WallFields none = makeFields(StateGrid(), {});
  CHECK(none.cellAt(0, 0) == -1);
  CHECK(none.distances[0].empty());
}

TEST_CASE("depths are told apart as far in fine cells as in others", "[features]") {
  // A hall of 9 m, whose middle is 4.5 m from the walls.
  for (const double resolution : {0.01, 0.02, 0.1}) {
    const int size = static_cast<int>(std::lround(9 / resolution));
    const WallFields fields = makeFields(test::freeGrid(size, size, resolution), {});
    const auto depthAt = [&](double x) {
      return fields.depthAt({x, 4.5}) * WallFields::depth_unit;
    };
    INFO(resolution << " m");
    CHECK(depthAt(4.5) == Approx(3.825));
    CHECK(depthAt(3.1) == Approx(3.1).margin(0.2));
    CHECK(depthAt(2.1) == Approx(2.1).margin(0.2));
    CHECK(depthAt(1.1) == Approx(1.1).margin(0.15));
  }
}
