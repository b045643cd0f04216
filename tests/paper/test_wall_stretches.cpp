// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/paper/wall_stretches.h"

using namespace sbox;

TEST_CASE("gaps end a stretch and short stretches are left out", "[paper]") {
  // Lower row: six cells, a gap of one, two cells, a gap of three, two cells.
  const StateGrid grid = test::gridFromText({"                ",  //
                                             "######.##...##  "},
                                            0.5);
  StretchOptions options;
  options.wall_width = 0.5;
  options.max_gap = 0.5;
  options.min_length = 2;
  // y = 0.25: theta is a right angle, and positions along the line are -x.
  const auto stretches = findWallStretches(grid, M_PI / 2, 0.25, options);
  REQUIRE(stretches.size() == 1);
  CHECK(stretches[0].begin == Approx(-4.5).margin(0.5));
  CHECK(stretches[0].end == Approx(0).margin(0.5));
  CHECK(stretches[0].cells == std::vector<size_t>{0, 1, 2, 3, 4, 5, 7, 8});

  options.max_gap = 1.5;
  const auto bridged = findWallStretches(grid, M_PI / 2, 0.25, options);
  REQUIRE(bridged.size() == 1);
  CHECK(bridged[0].cells.size() == 10);

  options.max_gap = 0;
  const auto split = findWallStretches(grid, M_PI / 2, 0.25, options);
  REQUIRE(split.size() == 1);
  CHECK(split[0].cells.size() == 6);
}

TEST_CASE("the wall's width decides which cells belong to it", "[paper]") {
  const StateGrid grid = test::gridFromText({"#####",  //
                                             "#####",  //
                                             "#####"},
                                            0.1);
  StretchOptions options;
  options.min_length = 0.3;
  options.wall_width = 0.1;
  CHECK(findWallStretches(grid, M_PI / 2, 0.15, options).at(0).cells.size() == 5);
  options.wall_width = 0.2;
  CHECK(findWallStretches(grid, M_PI / 2, 0.15, options).at(0).cells.size() == 15);
}

TEST_CASE("a line off the grid meets nothing", "[paper]") {
  const StateGrid grid = test::gridFromText({"####"}, 0.1);
  StretchOptions options;
  options.min_length = 0.1;
  CHECK(findWallStretches(grid, M_PI / 2, 5, options).empty());
  CHECK(findWallStretches(grid, M_PI / 4, -3, options).empty());
}
