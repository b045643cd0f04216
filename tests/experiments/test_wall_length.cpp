// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox-paper/answers.h"
#include "sbox-paper/wall_length.h"

using namespace sbox;
using namespace sbox::paper;

namespace {

constexpr double kCell = 0.05;

/// A room whose walls are one cell thick; 81 free cells by 61, with its corner at (-1, -1).
Map room() {
  Map map = makeMap("room", 83, 63, kCell, {-1, -1, 0});
  for (int y = 0; y < 63; ++y) {
    for (int x = 0; x < 83; ++x) {
      const bool wall = x == 0 || y == 0 || x == 82 || y == 62;
      map.grid.setCell(x, y, wall ? 0.05F : 0.95F);
    }
  }
  return map;
}

/// The lower wall between the centres of the corner cells, the room to its left.
const LineSegment kLowerWall{{-0.975, -0.975}, {3.125, -0.975}};

}  // namespace

TEST_CASE("a wall is as long as from corner cell to corner cell", "[wall length]") {
  const auto length = wallLength(classifyCells(room()), kLowerWall);
  REQUIRE(length);
  CHECK(*length == Approx(82 * kCell));
  // The left wall, downwards, has the room to its left too.
  CHECK(*wallLength(classifyCells(room()), {{-0.975, 2.125}, {-0.975, -0.975}}) ==
        Approx(62 * kCell));
}

TEST_CASE("a turned map shows the same length to about a cell", "[wall length]") {
  for (const double angle : {0.3, M_PI / 4, M_PI / 2, 2.5}) {
    const Map turned = turnedMap(room(), angle);
    const Pose2D turn(0, 0, angle);
    const auto length = wallLength(classifyCells(turned), {turn.composePoint(kLowerWall.from),
                                                           turn.composePoint(kLowerWall.to)});
    REQUIRE(length);
    CHECK(*length == Approx(82 * kCell).margin(kCell));
  }
}

TEST_CASE("a second wall in front of the corner shortens what is measured", "[wall length]") {
  Map map = room();
  for (int y = 0; y < 20; ++y) {
    map.grid.setCell(78, y, 0.05F);
  }
  CHECK(*wallLength(classifyCells(map), kLowerWall) == Approx(78 * kCell));
}

TEST_CASE("a wall without an end or without a free middle has no length", "[wall length]") {
  Map open = room();
  for (int y = 0; y < 62; ++y) {
    open.grid.setCell(82, y, 0.5F);
  }
  CHECK_FALSE(wallLength(classifyCells(open), kLowerWall));
  CHECK_FALSE(wallLength(classifyCells(room()), {{-0.975, 5}, {3.125, 5}}));
}
