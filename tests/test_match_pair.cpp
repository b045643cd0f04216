// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/match_pair.h"

using namespace sbox;
using test::Floor;
using test::Window;

namespace {

constexpr double kCell = 0.1;

MapFeatures seen(const Floor& floor, const Pose2D& map_in_world, const Window& window = {},
                 double resolution = kCell) {
  return extractFeatures(test::exploreMap(floor, map_in_world, resolution, window));
}

/// The first robot saw all but the east end of the office, the second all but the west end.
const Window kWest{{-1, -1}, {18, 15}}, kEast{{3, -1}, {25, 15}};
const Pose2D kFirstInWorld(2, 1, 0);

/// How far the result puts the corners of an office from where they are, in metres, at most.
double errorOf(const Pose2D& pose_b_in_a, const Pose2D& expected) {
  double error = 0;
  for (const Point2D& p : {Point2D(0, 0), Point2D(24, 0), Point2D(24, 14), Point2D(0, 14)}) {
    const Point2D in_b = (inverse(expected)).composePoint(p);
    const Point2D off = pose_b_in_a.composePoint(in_b) - p;
    error = std::max(error, std::hypot(off.x, off.y));
  }
  return error;
}

void checkAccepted(const PairResult& result, const Pose2D& expected, double tolerance = 0.2) {
  INFO(result.reason);
  CHECK(result.verdict == Verdict::Accepted);
  REQUIRE(result.has_pose);
  CHECK(errorOf(result.pose_b_in_a, expected) < tolerance);
  CHECK(result.confidence > 0.7);
  CHECK(result.confidence <= 1);
}

bool same(const Pose2D& left, const Pose2D& right) {
  return left.x == right.x && left.y == right.y && left.phi == right.phi;
}

/// That one result is the inverse of the other, to the last bit.
void checkExchanged(const PairResult& there, const PairResult& back) {
  CHECK(there.verdict == back.verdict);
  CHECK(there.reason == back.reason);
  CHECK(there.has_pose == back.has_pose);
  CHECK(there.confidence == back.confidence);
  CHECK(there.overlap_m2 == back.overlap_m2);
  const auto areInverse = [](const Pose2D& p, const Pose2D& q) {
    return same(p, inverse(q)) || same(q, inverse(p));
  };
  CHECK((!there.has_pose || areInverse(there.pose_b_in_a, back.pose_b_in_a)));
  REQUIRE(there.alternatives.size() == back.alternatives.size());
  for (size_t i = 0; i < there.alternatives.size(); ++i) {
    CHECK(areInverse(there.alternatives[i].pose_b_in_a, back.alternatives[i].pose_b_in_a));
    CHECK(there.alternatives[i].confidence == back.alternatives[i].confidence);
  }
  REQUIRE(there.matched_boxes.size() == back.matched_boxes.size());
  for (size_t i = 0; i < there.matched_boxes.size(); ++i) {
    CHECK(there.matched_boxes[i].first == back.matched_boxes[i].second);
    CHECK(there.matched_boxes[i].second == back.matched_boxes[i].first);
  }
}

/// The floor as if drawn on a sheet that is then pulled: walls meet at 60 degrees.
Floor sheared(Floor floor) {
  const auto pull = [](const Point2D& p) {
    return Point2D(p.x + 0.5 * p.y, p.y * std::sqrt(3) / 2);
  };
  for (test::Wall& wall : floor.walls) {
    wall = {pull(wall.from), pull(wall.to)};
  }
  for (Point2D& place : floor.places) {
    place = pull(place);
  }
  return floor;
}

Floor roundHall(double radius) {
  std::vector<Point2D> rim;
  for (int i = 0; i < 180; ++i) {
    rim.emplace_back(radius * std::cos(i * M_PI / 90), radius * std::sin(i * M_PI / 90));
  }
  return {test::wallsRound(rim), {{0, 0}}};
}

}  // namespace

TEST_CASE("two robots' maps of an office are matched", "[pair]") {
  const MapFeatures first = seen(test::officeFloor(), kFirstInWorld, kWest);
  for (const Pose2D& second_in_world :
       {Pose2D(2, 1, 0), Pose2D(15, -6, 0), Pose2D(2, 1, 2.1), Pose2D(15, -6, -0.9)}) {
    const PairResult result = matchPair(first, seen(test::officeFloor(), second_in_world, kEast));
    checkAccepted(result, inverse(kFirstInWorld) + second_in_world);
    CHECK(result.matched_boxes.size() > 5);
    // Both saw the 15 m x 14 m in the middle.
    CHECK(result.overlap_m2 == Approx(15 * 14).epsilon(0.15));
  }
}

TEST_CASE("a map is matched with itself at no distance", "[pair]") {
  const MapFeatures features = seen(test::officeFloor(), {4, 4, 0.3});
  checkAccepted(matchPair(features, features), {0, 0, 0}, 0.02);
}

TEST_CASE("exchanging the maps gives the inverse, exactly", "[pair]") {
  const MapFeatures office = seen(test::officeFloor(), kFirstInWorld, kWest);
  const MapFeatures other = seen(test::officeFloor(), {15, -6, -0.9}, kEast);
  const MapFeatures stranger = seen(test::randomFloor(1), {1, 2, 0.4});
  const MapFeatures nothing = extractFeatures(makeMap("nothing", 20, 20, kCell));
  for (const MapFeatures* second : {&other, &stranger, &nothing}) {
    checkExchanged(matchPair(office, *second), matchPair(*second, office));
  }
}

TEST_CASE("moving a map's frame moves the answer", "[pair]") {
  const Map first = test::exploreMap(test::officeFloor(), kFirstInWorld, kCell, kWest);
  const Map second = test::exploreMap(test::officeFloor(), {15, -6, -0.9}, kCell, kEast);
  const PairResult plain = matchPair(extractFeatures(first), extractFeatures(second));
  for (const Pose2D& moved : {Pose2D(7, -3, 0), Pose2D(0, 0, 2.5), Pose2D(7, -3, -0.8)}) {
    Map first_moved = first, second_moved = second;
    first_moved.corner_in_map = moved + first.corner_in_map;
    second_moved.corner_in_map = moved + second.corner_in_map;
    const PairResult of_first = matchPair(extractFeatures(first_moved), extractFeatures(second));
    const PairResult of_second = matchPair(extractFeatures(first), extractFeatures(second_moved));
    CHECK(errorOf(of_first.pose_b_in_a, moved + plain.pose_b_in_a) < 1e-6);
    CHECK(errorOf(of_second.pose_b_in_a, plain.pose_b_in_a + inverse(moved)) < 1e-6);
    CHECK(of_first.confidence == Approx(plain.confidence));
    CHECK(of_second.verdict == plain.verdict);
  }
}

TEST_CASE("maps of different cell sizes are matched", "[pair]") {
  const Pose2D second_in_world(15, -6, -0.9);
  for (const double first_cell : {0.05, 0.2}) {
    checkAccepted(matchPair(seen(test::officeFloor(), kFirstInWorld, kWest, first_cell),
                            seen(test::officeFloor(), second_in_world, kEast, 0.1)),
                  inverse(kFirstInWorld) + second_in_world, 0.25);
  }
}

TEST_CASE("walls at sixty degrees are matched", "[pair]") {
  const Floor floor = sheared(test::officeFloor());
  const Pose2D second_in_world(8, 3, 1.0);
  checkAccepted(matchPair(seen(floor, kFirstInWorld, {{-1, -1}, {22, 15}}),
                          seen(floor, second_in_world, {{5, -1}, {40, 15}})),
                inverse(kFirstInWorld) + second_in_world);
}

TEST_CASE("maps without walls are refused, saying so", "[pair]") {
  const MapFeatures office = seen(test::officeFloor(), {});
  Map free = makeMap("free", 80, 60, kCell);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) {
      free.grid.setCell(x, y, 1.0F);
    }
  }
  for (const Map& map : {makeMap("unknown", 80, 60, kCell), free}) {
    const MapFeatures nothing = extractFeatures(map);
    for (const PairResult& result : {matchPair(office, nothing), matchPair(nothing, office)}) {
      CHECK(result.verdict == Verdict::Rejected);
      CHECK_FALSE(result.has_pose);
      CHECK(result.confidence == 0);
      CHECK(result.reason == "one of the maps has no wall with free space beside it");
    }
    CHECK(matchPair(nothing, nothing).reason == "neither map has a wall with free space beside it");
  }
}

TEST_CASE("halves of a random office are matched", "[pair]") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Floor floor = test::randomFloor(seed);
    const Pose2D second_in_world(5, 1, -1.3);
    INFO("seed " << seed);
    checkAccepted(matchPair(seen(floor, {}, {{-1, -1}, {15, 20}}),
                            seen(floor, second_in_world, {{4, -1}, {40, 20}})),
                  second_in_world);
  }
}

TEST_CASE("bare floors of one style are not often taken for each other", "[pair]") {
  // Without furniture, a room of one floor that by chance is as wide as one of the other is all
  // that two maps need to overlap in: the weak spot of the verdict, which furnished offices do not
  // hit.
  constexpr unsigned pairs = 20;
  int accepted = 0;
  for (unsigned seed = 1; seed <= pairs; ++seed) {
    const PairResult result = matchPair(seen(test::randomFloor(seed), {}),
                                        seen(test::randomFloor(seed + 1), {3, 1, 0.2 * seed}));
    accepted += result.verdict == Verdict::Accepted ? 1 : 0;
  }
  CHECK(accepted <= 8);
}

TEST_CASE("maps that could slide along two walls are not matched", "[pair]") {
  const Floor corridor{{{{-50, 0}, {50, 0}}, {{-50, 2.5}, {50, 2.5}}}, {{0, 1}}};
  const PairResult result = matchPair(seen(corridor, {}, {{-12, -1}, {10, 4}}),
                                      seen(corridor, {1, 2, 0.5}, {{-8, -1}, {16, 4}}));
  INFO(result.reason);
  CHECK(result.verdict != Verdict::Accepted);
  CHECK(result.confidence < 0.5);
}

TEST_CASE("of two equal rooms none is taken for the other", "[pair]") {
  // Two halls that are alike, turned against each other, and a map of one of them.
  const std::vector<Point2D> hall{{1, 0}, {11, 0}, {11, 5}, {6, 5}, {6, 9}, {1, 9}};
  Floor both{test::wallsRound(hall), {{3, 2}}};
  const Floor one = both;
  std::vector<Point2D> turned;
  for (const Point2D& p : hall) {
    turned.emplace_back(-p.x, -p.y);
  }
  const auto opposite = test::wallsRound(turned);
  both.walls.insert(both.walls.end(), opposite.begin(), opposite.end());
  both.places.emplace_back(-3, -2);
  const Pose2D second_in_world(2, 3, 0.7);
  const PairResult result = matchPair(seen(both, {}), seen(one, second_in_world));
  INFO(result.reason);
  CHECK(result.verdict == Verdict::Ambiguous);
  CHECK(result.confidence <= 0.55);
  REQUIRE(!result.alternatives.empty());
  // Both answers are told, the second not much less likely than the first.
  CHECK(result.alternatives[0].confidence > 0.2);
  const Pose2D here = second_in_world, there = Pose2D(0, 0, M_PI) + second_in_world;
  const bool first_is_here = errorOf(result.pose_b_in_a, here) < 0.3;
  CHECK(errorOf(result.pose_b_in_a, first_is_here ? here : there) < 0.3);
  CHECK(errorOf(result.alternatives[0].pose_b_in_a, first_is_here ? there : here) < 0.3);
}

TEST_CASE("a round hall fits itself at any heading, and is not matched", "[pair]") {
  const PairResult result = matchPair(seen(roundHall(5), {}), seen(roundHall(5), {1, 2, 0.6}));
  INFO(result.reason);
  CHECK(result.verdict != Verdict::Accepted);
  // Neither is a hall in an office.
  CHECK(matchPair(seen(roundHall(5), {}), seen(test::officeFloor(), {})).verdict !=
        Verdict::Accepted);
}

TEST_CASE("the number of threads changes no bit of a pair's result", "[match_pair]") {
  const Floor floor = test::officeFloor();
  const MapFeatures a = seen(floor, kFirstInWorld, kWest);
  const MapFeatures b = seen(floor, {-3, 4, 1.1}, kEast);
  PairOptions options;
  options.sure = GENERATE(0.5, 1.01);  // Votes suffice; all is searched, too.
  const PairResult one = matchPair(a, b, options, {}, 1);
  REQUIRE(one.has_pose);
  for (const int threads : {2, 5}) {
    INFO(threads << " threads");
    const PairResult several = matchPair(a, b, options, {}, threads);
    CHECK(several.reason == one.reason);
    CHECK(several.confidence == one.confidence);
    CHECK(same(several.pose_b_in_a, one.pose_b_in_a));
    CHECK(several.covariance == one.covariance);
    REQUIRE(several.alternatives.size() == one.alternatives.size());
    for (size_t i = 0; i < one.alternatives.size(); ++i) {
      CHECK(same(several.alternatives[i].pose_b_in_a, one.alternatives[i].pose_b_in_a));
      CHECK(several.alternatives[i].confidence == one.alternatives[i].confidence);
    }
  }
}
