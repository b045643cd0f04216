// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox-dataset/world.h"

using namespace sbox;
using namespace sbox::dataset;

TEST_CASE("a world file holds polylines and turned boxes", "[world]") {
  const ScratchFolder scratch;
  const World world = loadWorld(scratch.write("w",
                                              "# a room\n"
                                              "wall 0 0  4 0  4 3\n"
                                              "\n"
                                              "box 10 20  2 1  90  # a table\n"));
  REQUIRE(world.walls.size() == 6);
  CHECK(world.walls[1].from.x == 4);
  CHECK(world.walls[1].to.y == 3);
  CHECK(world.walls[2].from.x == Approx(10.5));
  CHECK(world.walls[2].from.y == Approx(19));
}

TEST_CASE("a world survives a file", "[world]") {
  const ScratchFolder scratch;
  const World world = loadWorld(scratch.write("w",
                                              "slab 0 0  4 0  0.2\n"
                                              "place 1.5 2\n"
                                              "yardstick 0.5 1  2 3\n"));
  saveWorld(world, scratch.path("again"));
  const World again = loadWorld(scratch.path("again"));
  REQUIRE(again.walls.size() == 4);
  CHECK(again.walls[0].from.y == Approx(-0.1));
  CHECK(again.walls[1].from.x == Approx(4));
  REQUIRE(again.places.size() == 1);
  CHECK(again.places[0].x == 1.5);
  REQUIRE(again.yardsticks.size() == 1);
  CHECK(again.yardsticks[0].to.y == 3);
  CHECK_THROWS(saveWorld(world, scratch.path("none/there")));
}

TEST_CASE("a world file with a fault is refused by its line", "[world]") {
  const ScratchFolder scratch;
  CHECK_THROWS_WITH(loadWorld(scratch.write("w", "wall 0 0 1 1\nwall 0 0 1\n")),
                    scratch.path("w") + ":2: expected: wall x y x y [x y ...]");
  CHECK_THROWS_WITH(loadWorld(scratch.write("w", "wall 0 0 1 one\n")),
                    scratch.path("w") + ":1: not a number");
  CHECK_THROWS(loadWorld(scratch.write("w", "tree 0 0\n")));
  CHECK_THROWS_WITH(loadWorld(scratch.path("none")), scratch.path("none") + ": cannot be read");
}

TEST_CASE("distanceToWall finds the nearest wall ahead", "[world]") {
  World world;
  world.walls = {{{2, -1}, {2, 1}}, {{5, -1}, {5, 1}}, {{-3, -1}, {-3, 1}}};
  CHECK(distanceToWall(world, {0, 0}, 0) == Approx(2));
  CHECK(distanceToWall(world, {0, 0}, M_PI) == Approx(3));
  CHECK(distanceToWall(world, {0, 0}, 0.2) == Approx(2 / std::cos(0.2)));
  CHECK(std::isinf(distanceToWall(world, {0, 0}, M_PI / 2)));
  CHECK(std::isinf(distanceToWall(world, {0, 1.5}, 0)));
}
