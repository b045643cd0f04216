// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "catch.h"
#include "drawing.h"
#include "sbox/bending/bend_maps.h"

using namespace sbox;

namespace {

constexpr double kCell = 0.05;

/// The office as a robot with a drifting SLAM has it: a point at x lies lower by this much.
double sag(double x) { return 0.5 * std::sin(x / 24 * M_PI); }

test::Floor saggingOffice() {
  test::Floor floor = test::officeFloor();
  std::vector<test::Wall> pieces;
  for (const test::Wall& wall : floor.walls) {
    constexpr int parts = 60;
    const auto at = [&](int i) {
      const Point2D p = wall.from + (wall.to - wall.from) * (static_cast<double>(i) / parts);
      return Point2D(p.x, p.y - sag(p.x));
    };
    for (int i = 0; i < parts; ++i) {
      pieces.push_back({at(i), at(i + 1)});
    }
  }
  floor.walls = std::move(pieces);
  return floor;
}

/// Share of shared cells where the maps conflict.
double conflict(const Map& a, const Map& b, const Pose2D& pose_b_in_a) {
  return fuseMaps({{&a, Pose2D()}, {&b, pose_b_in_a}}, 0).conflict_share;
}

bool sameCells(const Map& one, const Map& other) {
  return one.grid.getRawMap() == other.grid.getRawMap() && one.width() == other.width() &&
         one.corner_in_map == other.corner_in_map;
}

}  // namespace

TEST_CASE("a map that has drifted is bent onto the reference, which stays", "[bending]") {
  const Pose2D b_in_world(3, 2, 0.7);
  const Map a = test::exploreMap(test::officeFloor(), {}, kCell);
  const Map b = test::exploreMap(saggingOffice(), b_in_world, kCell);
  // The best that a rigid transform can do is to lift the map by the mean.
  Pose2D pose = b_in_world;
  pose.y += 0.32;
  const std::vector<BentMap> bent = bendMaps({{&a, Pose2D()}, {&b, pose}}, 0);
  REQUIRE(bent.size() == 2);
  CHECK(sameCells(bent[0].map, a));
  CHECK(bent[1].is_bent);
  CHECK(bent[1].shift > 0.05);
  CHECK(bent[1].shift < 0.4);
  CHECK(conflict(a, bent[1].map, Pose2D()) < 0.5 * conflict(a, b, pose));
}

TEST_CASE("the order of the maps changes no cell", "[bending]") {
  const Pose2D b_in_world(3, 2, 0.7), c_in_world(8, -1, -1.2);
  const Map a = test::exploreMap(test::officeFloor(), {}, kCell);
  const Map b = test::exploreMap(saggingOffice(), b_in_world, kCell, {{-1, -2}, {15, 15}});
  const Map c = test::exploreMap(saggingOffice(), c_in_world, kCell, {{6, -2}, {25, 15}});
  const PlacedMap at_a{&a, Pose2D()}, at_b{&b, b_in_world}, at_c{&c, c_in_world};
  const std::vector<BentMap> there = bendMaps({at_a, at_b, at_c}, 0);
  const std::vector<BentMap> back = bendMaps({at_c, at_b, at_a}, 2);
  for (size_t i = 0; i < 3; ++i) {
    CHECK(sameCells(there[i].map, back[2 - i].map));
    CHECK(there[i].shift == back[2 - i].shift);
  }
}

TEST_CASE("a map that meets no other lies as it was placed", "[bending]") {
  const Map a = test::exploreMap(test::officeFloor(), {}, kCell);
  const Map b = test::exploreMap(saggingOffice(), {}, kCell);
  const Pose2D far(500, 0, 0.3);
  const std::vector<BentMap> bent = bendMaps({{&a, Pose2D()}, {&b, far}}, 0);
  CHECK_FALSE(bent[1].is_bent);
  CHECK(bent[1].shift == 0);
  CHECK(bent[1].map.grid.getRawMap() == b.grid.getRawMap());
  const Pose2D expected = far + b.corner_in_map;
  CHECK(bent[1].map.corner_in_map.x == Approx(expected.x));
  CHECK(bent[1].map.corner_in_map.phi == Approx(expected.phi));
}
