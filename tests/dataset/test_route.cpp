// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox-dataset/office.h"
#include "sbox-dataset/route.h"
#include "sbox-dataset/world_grid.h"

using namespace sbox;
using namespace sbox::dataset;

namespace {

/// Two rooms of 4 m x 4 m with a door of 1 m between them, off their middle.
World twoRooms() {
  World world;
  world.walls = {{{0, 0}, {8, 0}}, {{8, 0}, {8, 4}},   {{8, 4}, {0, 4}},
                 {{0, 4}, {0, 0}}, {{4, 0}, {4, 2.8}}, {{4, 3.8}, {4, 4}}};
  return world;
}

double lengthOf(const Path& path) {
  Point2D at(path.start_in_world.x, path.start_in_world.y);
  double length = 0;
  for (const Point2D& point : path.points_in_world) {
    length += (point - at).norm();
    at = point;
  }
  return length;
}

/// Distance of a way's closest approach to a wall, looked at in all directions each 0.02 m.
double closestApproach(const World& world, const Path& path) {
  Point2D at(path.start_in_world.x, path.start_in_world.y);
  double closest = 1e9;
  for (const Point2D& point : path.points_in_world) {
    const int steps = static_cast<int>(std::ceil((point - at).norm() / 0.02));
    for (int i = 0; i <= steps; ++i) {
      const Point2D eye = at + (point - at) * (i / static_cast<double>(std::max(1, steps)));
      for (int beam = 0; beam < 180; ++beam) {
        closest = std::min(closest, distanceToWall(world, eye, beam * M_PI / 90));
      }
    }
    at = point;
  }
  return closest;
}

}  // namespace

TEST_CASE("a route leads through the door and not through the wall", "[route]") {
  const World world = twoRooms();
  const RoutePlanner planner(worldGrid(world, 0.05));
  const Path path = planner.tour({1, 1, 0}, {{7, 1}});
  REQUIRE_FALSE(path.points_in_world.empty());
  CHECK(path.points_in_world.back().x == Approx(7).margin(0.03));
  // Through the door's middle it is 2 * hypot(3, 2.3) = 7.6 m, straight through the wall 6 m.
  CHECK(lengthOf(path) > 7);
  CHECK(lengthOf(path) < 8.5);
  CHECK(closestApproach(world, path) > 0.2);
}

TEST_CASE("a place behind walls or inside one is left out", "[route]") {
  const World world = twoRooms();
  const RoutePlanner planner(worldGrid(world, 0.05));
  CHECK(planner.route({1, 1}, {9, 1}).empty());
  CHECK(planner.route({1, 1}, {4, 1}).empty());
  const Path path = planner.tour({1, 1, 0}, {{4, 1}, {3, 1}});
  REQUIRE_FALSE(path.points_in_world.empty());
  CHECK(path.points_in_world.back().x == Approx(3).margin(0.03));
}

TEST_CASE("nearly every place of a random office can be reached, and offices differ", "[route]") {
  int places = 0, reached = 0;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const World office = randomOffice(seed);
    REQUIRE(office.places.size() >= 8);
    const RoutePlanner planner(worldGrid(office, 0.05));
    const Point2D start = office.places.back();  // In the corridor.
    for (const Point2D& place : office.places) {
      ++places;
      reached += (place - start).norm() < 0.1 || !planner.route(start, place).empty() ? 1 : 0;
    }
  }
  CHECK(reached > 0.85 * places);
  CHECK(randomOffice(1).walls.size() != randomOffice(2).walls.size());
  CHECK(randomOffice(3).walls.back().from.x == randomOffice(3).walls.back().from.x);
}
