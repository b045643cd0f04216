// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/core/state_grid.h"
#include "sbox/placement/footprint.h"

using namespace sbox;

namespace {

/// 10 m x 5 m of free cells, with the frame's origin at the lower-left corner.
Footprint hall() {
  Map map = makeMap("hall", 100, 50, 0.1);
  map.grid.fill(0.9F);
  return footprintOf(map);
}

}  // namespace

TEST_CASE("a footprint knows the middle and the extent of what a map knows") {
  const Footprint footprint = hall();
  CHECK(footprint.centre.x == Approx(5));
  CHECK(footprint.centre.y == Approx(2.5));
  CHECK(footprint.radius == Approx(std::sqrt((100 + 25) / 12.0)).epsilon(0.02));
  CHECK(static_cast<double>(footprint.known.size()) * footprint.cell * footprint.cell ==
        Approx(50));
}

TEST_CASE("a coarse cell is known if half of its cells are") {
  std::mt19937 random(2);
  Map map = makeMap("patches", 157, 113, 0.05, {3, -2, 0.4});
  for (int y = 7; y < 107; ++y) {
    for (int x = 12; x < 151; ++x) {
      // Well known at the left, hardly at the right.
      const bool known = static_cast<int>(random() % 150) > x;
      map.grid.setCell(x, y, !known ? 0.5F : random() % 2 == 0 ? 0.05F : 0.95F);
    }
  }
  const Footprint footprint = footprintOf(map);
  const StateGrid grid = classifyCells(map);
  const int block = 10;
  REQUIRE(footprint.cell == Approx(block * 0.05));
  REQUIRE(footprint.width == (grid.width + block - 1) / block);
  REQUIRE(footprint.height == (grid.height + block - 1) / block);
  CHECK(footprint.corner_in_map.x == grid.corner_in_map.x);
  CHECK(footprint.corner_in_map.y == grid.corner_in_map.y);
  int marked = 0, wrong = 0;
  for (int row = 0; row < footprint.height; ++row) {
    for (int column = 0; column < footprint.width; ++column) {
      int known = 0;
      for (int i = 0; i < block * block; ++i) {
        known += grid.at(column * block + i % block, row * block + i / block) != CellState::Unknown;
      }
      const bool mark = footprint.cells[static_cast<size_t>(row * footprint.width + column)] != 0;
      marked += mark ? 1 : 0;
      wrong += mark == (known >= block * block / 2) ? 0 : 1;
    }
  }
  CHECK(marked > 30);
  CHECK(marked < footprint.width * footprint.height - 30);
  CHECK(wrong == 0);
}

TEST_CASE("points that both maps know are those that fall on known cells of the other") {
  const Footprint a = hall();
  const Footprint b = hall();
  const Pose2D pose(4, -2, 0.7);
  std::vector<Point2D> expected;
  for (const Point2D& point : b.known) {
    const Point2D in_a = pose.composePoint(point);
    if (in_a.x >= 0 && in_a.y >= 0 && in_a.x < 10 && in_a.y < 5) {
      expected.push_back(in_a);
    }
  }
  const std::vector<Point2D> found = commonPoints(a, b, pose);
  REQUIRE(expected.size() > 20);
  REQUIRE(found.size() == expected.size());
  for (size_t i = 0; i < found.size(); ++i) {
    CHECK(found[i].x == Approx(expected[i].x));
    CHECK(found[i].y == Approx(expected[i].y));
  }
}

TEST_CASE("a map without known cells has an empty footprint") {
  const Footprint footprint = footprintOf(makeMap("nothing", 20, 20, 0.1));
  CHECK(footprint.known.empty());
  CHECK(overlapShare(footprint, hall(), {}) == 0);
}

TEST_CASE("the overlap is a share of the smaller map, whichever comes first") {
  const Footprint large = hall();
  Map map = makeMap("room", 40, 40, 0.1);
  map.grid.fill(0.9F);
  const Footprint small = footprintOf(map);
  CHECK(overlapShare(large, large, {}) == Approx(1));
  CHECK(overlapShare(large, large, {5, 0, 0}) == Approx(0.5));
  CHECK(overlapShare(large, large, {10, 5, M_PI}) == Approx(1));
  CHECK(overlapShare(large, large, {0, 6, 0}) == 0);
  const Pose2D half_outside(8, 1, 0);
  CHECK(overlapShare(large, small, half_outside) == Approx(0.5));
  CHECK(overlapShare(small, large, inverse(half_outside)) == Approx(0.5));
}

TEST_CASE("the gap between poses is taken at the middles of the maps") {
  const Footprint a = hall(), b = hall();
  const PoseGap shifted = gapBetween(a, b, {1, 2, 0.5}, {1.3, 2.4, 0.5});
  CHECK(shifted.distance == Approx(0.5));
  CHECK(shifted.turn == 0);
  // A turn about the common middle moves neither.
  const double turn = 0.1;
  const Point2D middle(5, 2.5);
  const Point2D turned = Pose2D(0, 0, turn).composePoint(middle);
  const PoseGap gap = gapBetween(a, b, {}, {middle.x - turned.x, middle.y - turned.y, turn});
  CHECK(gap.distance == Approx(0).margin(1e-6));
  CHECK(gap.turn == Approx(turn));
  CHECK(gapBetween(a, b, {0, 0, 3.1}, {0, 0, -3.1}).turn == Approx(2 * M_PI - 6.2));
}

TEST_CASE("what is known is what the states say") {
  Map pale = makeMap("pale", 100, 50, 0.1);
  pale.grid.fill(0.58F);
  CHECK(footprintOf(pale).known.empty());
  StateOptions states;
  states.free_above = 0.55;
  CHECK(footprintOf(pale, states).known.size() == hall().known.size());
  CHECK(footprintsOf({pale}, states, 1)[0].centre.x == Approx(5));
}
