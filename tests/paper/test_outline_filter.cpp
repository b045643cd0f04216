// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "drawing.h"
#include "sbox/paper/outline_filter.h"

using namespace sbox;

namespace {

// One cell is 1 m; the wall stands in column 3.
const StateGrid kGrid = test::gridFromText({".......  ",  //
                                            "...#...  ",  //
                                            ".......  "},
                                           1.0);

bool near(double x, double y, double reach) {
  OutlineOptions options;
  options.reach = reach;
  return nearOutline(kGrid, {x, y}, options);
}

}  // namespace

TEST_CASE("a point within reach of another state is on the outline", "[paper]") {
  CHECK(near(3.5, 1.5, 1));        // The wall itself.
  CHECK(near(1.5, 1.5, 2));        // Two cells left of it.
  CHECK_FALSE(near(1.5, 1.5, 1));  // Out of reach.
  CHECK(near(6.5, 0.5, 1));        // Beside the unknown.
  CHECK(near(0.5, 1.5, 1));        // At the grid's edge: all is unknown outside.
}

TEST_CASE("only the four directions are walked", "[paper]") {
  const StateGrid diagonal = test::gridFromText({"....#",  //
                                                 ".....",  //
                                                 ".....",  //
                                                 ".....",  //
                                                 "....."},
                                                1.0);
  OutlineOptions options;
  options.reach = 1;
  CHECK_FALSE(nearOutline(diagonal, {3.5, 3.5}, options));
  CHECK(nearOutline(diagonal, {3.5, 4.5}, options));
}

TEST_CASE("far off the grid and without a grid there is no outline", "[paper]") {
  CHECK_FALSE(near(-50, 1.5, 2));
  CHECK_FALSE(near(1e300, 1e300, 2));
  CHECK_FALSE(nearOutline(StateGrid(), {0, 0}));
}

TEST_CASE("clusters off the outline are dropped", "[paper]") {
  OutlineOptions options;
  options.reach = 1;
  const std::vector<PointCluster> clusters = {{{1.5, 1.5}, {0}}, {{3.5, 1.5}, {1}}};
  const auto kept = filterByOutline(kGrid, clusters, options);
  REQUIRE(kept.size() == 1);
  CHECK(kept[0].members == std::vector<int>{1});
}
