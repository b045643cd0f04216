// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "catch.h"
#include "sbox/placement/place_maps.h"

using namespace sbox;

namespace {

/// Two maps; the second lies at (5, 0), or else 12 m further on.
MapPair twoWays(Verdict verdict, double first, double second) {
  MapPair pair{0, 1, {}};
  pair.result.verdict = verdict;
  pair.result.has_pose = true;
  pair.result.pose_b_in_a = {5, 0, 0};
  pair.result.covariance = PoseCovariance::Identity() * 0.01;
  pair.result.confidence = first;
  pair.result.alternatives = {{{17, 0, 0}, second}};
  return pair;
}

PlacementResult place(const MapPair& pair, const std::vector<InitialGuess>& guesses) {
  Map room = makeMap("room", 100, 100, 0.1, {-5, -5, 0});
  room.grid.fill(0.9F);
  return placeMaps(std::vector<Footprint>(2, footprintOf(room)), {pair}, {}, {}, guesses);
}

}  // namespace

TEST_CASE("a guess breaks a tie") {
  const MapPair pair = twoWays(Verdict::Ambiguous, 0.48, 0.46);
  CHECK(place(pair, {}).groups.size() == 2);
  CHECK(place(pair, {{0, {}, 1, 0.1}}).groups.size() == 2);
  for (const double x : {5.0, 17.0}) {
    // In whatever frame: here one turned and shifted.
    const Pose2D frame(100, -20, 2);
    const PlacementResult placed =
        place(pair, {{0, frame, 1, 0.1}, {1, frame + Pose2D(x + 1, -1, 0.05), 1, 0.1}});
    REQUIRE(placed.groups.size() == 1);
    CHECK(placed.maps[1].pose.x == Approx(x));
    CHECK(placed.settlements[0]->candidate == (x == 5 ? 0 : 1));
  }
}

TEST_CASE("a wrong guess is overruled by maps that are sure") {
  const MapPair pair = twoWays(Verdict::Accepted, 0.995, 0.001);
  const PlacementResult placed = place(pair, {{0, {}, 1, 0.1}, {1, {17, 0, 0}, 1, 0.1}});
  REQUIRE(placed.groups.size() == 1);
  CHECK(placed.maps[1].pose.x == Approx(5));
  REQUIRE(placed.overruled.size() == 1);
  CHECK(placed.overruled[0].map == 1);
  CHECK(placed.overruled[0].beside == 0);
  CHECK(placed.overruled[0].distance == Approx(12));
  CHECK(placed.overruled[0].turn == Approx(0).margin(1e-9));
  // What a guess allows is not against it.
  CHECK(place(pair, {{0, {}, 1, 0.1}, {1, {9, 0, 0}, 1, 0.1}}).overruled.empty());
}

TEST_CASE("of many guesses the one that is wrong is told") {
  // Three maps in a row, 5 m from each to the next.
  Map room = makeMap("room", 100, 100, 0.1, {-5, -5, 0});
  room.grid.fill(0.9F);
  MapPair first = twoWays(Verdict::Accepted, 0.999, 1e-4), second = first;
  second.a = 1;
  second.b = 2;
  for (const int wrong : {0, 1, 2}) {
    std::vector<InitialGuess> guesses{
        {0, {0, 0, 0}, 0.5, 0.1}, {1, {5, 0, 0}, 0.5, 0.1}, {2, {10, 0, 0}, 0.5, 0.1}};
    guesses[static_cast<size_t>(wrong)].pose.y = 60;
    const PlacementResult placed =
        placeMaps(std::vector<Footprint>(3, footprintOf(room)), {first, second}, {}, {}, guesses);
    INFO("map " << wrong);
    REQUIRE(placed.groups.size() == 1);
    REQUIRE(placed.overruled.size() == 1);
    CHECK(placed.overruled[0].map == wrong);
  }
}

TEST_CASE("a guess that is far off makes a doubtful pair more doubtful, unless it is vague") {
  const MapPair pair = twoWays(Verdict::Accepted, 0.8, 0.01);
  CHECK(place(pair, {{0, {}, 1, 0.1}, {1, {40, 0, 3}, 1, 0.1}}).groups.size() == 2);
  CHECK(place(pair, {{0, {}, 50, 2}, {1, {40, 0, 3}, 50, 2}}).groups.size() == 1);
}

TEST_CASE("guesses of no map and two of one map are refused") {
  const MapPair pair = twoWays(Verdict::Accepted, 0.8, 0.01);
  CHECK_THROWS_AS(place(pair, {{2, {}, 1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(place(pair, {{0, {}, 1, 1}, {0, {}, 1, 1}}), std::invalid_argument);
}
