// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "catch.h"
#include "sbox/placement/place_maps.h"

using namespace sbox;

namespace {

MapPair accepted(int a, int b, const Pose2D& pose_b_in_a, double confidence) {
  MapPair pair{a, b, {}};
  pair.result.verdict = Verdict::Accepted;
  pair.result.has_pose = true;
  pair.result.pose_b_in_a = pose_b_in_a;
  pair.result.covariance = Eigen::Vector3d(0.01, 0.02, 0.001).asDiagonal();
  pair.result.confidence = confidence;
  return pair;
}

MapPair rejected(int a, int b) {
  MapPair pair = accepted(a, b, {9, 9, 1}, 0.3);
  pair.result.verdict = Verdict::Rejected;
  return pair;
}

/// Maps that are points at the origin of their frames.
std::vector<Footprint> points(size_t count) { return std::vector<Footprint>(count); }

/// A room of 4 m x 4 m, all known.
Footprint squareRoom() {
  Map map = makeMap("room", 40, 40, 0.1);
  map.grid.fill(0.9F);
  return footprintOf(map);
}

/// The same pair with its maps exchanged.
MapPair exchanged(MapPair pair) {
  std::swap(pair.a, pair.b);
  PairResult& result = pair.result;
  result.covariance = inverseCovariance(result.pose_b_in_a, result.covariance);
  result.pose_b_in_a = inverse(result.pose_b_in_a);
  for (Candidate& alternative : result.alternatives) {
    alternative.pose_b_in_a = inverse(alternative.pose_b_in_a);
  }
  return pair;
}

void checkPose(const Pose2D& pose, const Pose2D& expected, double margin = 1e-12) {
  CHECK(pose.x == Approx(expected.x).margin(margin));
  CHECK(pose.y == Approx(expected.y).margin(margin));
  CHECK(wrapAngle(pose.phi - expected.phi) == Approx(0).margin(margin));
}

}  // namespace

TEST_CASE("poses are composed along a chain of maps") {
  // Quarter turns: b lies at (1, 0) turned left, c two metres ahead of b.
  const PlacementResult placed = placeMaps(
      points(3), {accepted(0, 1, {1, 0, M_PI / 2}, 0.9), accepted(1, 2, {2, 0, M_PI / 2}, 0.8)});
  REQUIRE(placed.groups.size() == 1);
  CHECK(placed.groups[0].members == std::vector<int>{0, 1, 2});
  checkPose(placed.maps[0].pose, {0, 0, 0});
  checkPose(placed.maps[1].pose, {1, 0, M_PI / 2});
  checkPose(placed.maps[2].pose, {1, 2, M_PI});
  CHECK(placed.maps[0].covariance.norm() == 0);
}

TEST_CASE("another reference changes the frame only") {
  const std::vector<MapPair> pairs{accepted(0, 1, {1, 0, M_PI / 2}, 0.9),
                                   accepted(1, 2, {2, 0, M_PI / 2}, 0.8)};
  const PlacementResult placed = placeMaps(points(3), pairs, 2);
  CHECK(placed.groups[0].reference == 2);
  checkPose(placed.maps[2].pose, {0, 0, 0});
  checkPose(placed.maps[0].pose, {1, 2, M_PI});
}

TEST_CASE("of a cycle the most confident pairs are used") {
  const std::vector<MapPair> pairs{accepted(0, 1, {1, 0, 0}, 0.9), accepted(0, 2, {50, 50, 1}, 0.5),
                                   accepted(1, 2, {1, 0, 0}, 0.8)};
  checkPose(placeMaps(points(3), pairs).maps[2].pose, {2, 0, 0});
}

TEST_CASE("only accepted pairs of enough confidence join maps") {
  const std::vector<MapPair> pairs{rejected(0, 1), accepted(1, 2, {1, 0, 0}, 0.6), rejected(0, 2),
                                   accepted(2, 3, {1, 0, 0}, 0.4)};
  const PlacementResult placed = placeMaps(points(4), pairs);
  REQUIRE(placed.groups.size() == 2);
  CHECK(placed.groups[0].members == std::vector<int>{0});
  CHECK(placed.groups[1].members == std::vector<int>{1, 2, 3});
  CHECK(placed.largest == 1);
  CHECK(placed.maps[0].group == 0);
  CHECK(placed.maps[3].group == 1);
  CHECK(placed.groups[1].reference == 1);
  PlacementOptions strict;
  strict.min_confidence = 0.4;  // 0.6 counts for a little less where not half of the pairs join.
  CHECK(placeMaps(points(4), pairs, {}, strict).groups.size() == 3);
}

TEST_CASE("neither the order of the pairs nor that of the maps changes where maps lie") {
  // Five maps that all see each other, drifted; one pair is wrong, one ambiguous.
  const std::vector<Pose2D> truth{{0, 0, 0}, {4, 1, 0.7}, {-3, 5, -2.1}, {8, -2, 3.1}, {1, 9, 1.5}};
  std::vector<MapPair> pairs;
  for (int a = 0; a < 5; ++a) {
    for (int b = a + 1; b < 5; ++b) {
      const double drift = 0.1 * (a - 0.7 * b);
      pairs.push_back(accepted(a, b,
                               inverse(truth[static_cast<size_t>(a)]) +
                                   truth[static_cast<size_t>(b)] +
                                   Pose2D(drift, -drift, 0.1 * drift),
                               0.9 + 0.01 * a + 0.001 * b));
    }
  }
  pairs[2].result.pose_b_in_a.x += 20;
  pairs[5].result.verdict = Verdict::Ambiguous;
  pairs[5].result.confidence = 0.4;
  pairs[5].result.alternatives = {{pairs[5].result.pose_b_in_a, 0.35}};
  pairs[5].result.pose_b_in_a = {3, 3, 3};
  const PlacementResult placed = placeMaps(points(5), pairs);
  REQUIRE(placed.groups.size() == 1);

  const std::array<int, 5> new_number{3, 0, 4, 1, 2};
  std::vector<MapPair> renumbered;
  for (MapPair pair : pairs) {
    pair.a = new_number[static_cast<size_t>(pair.a)];
    pair.b = new_number[static_cast<size_t>(pair.b)];
    renumbered.push_back(pair.a < pair.b ? pair : exchanged(pair));
  }
  std::reverse(renumbered.begin(), renumbered.end());
  const PlacementResult again = placeMaps(points(5), renumbered, new_number[0]);
  REQUIRE(again.groups.size() == 1);
  for (size_t i = 0; i < 5; ++i) {
    const MapPlacement& here = placed.maps[i];
    const MapPlacement& there = again.maps[static_cast<size_t>(new_number[i])];
    checkPose(there.pose, here.pose, 1e-6);
    CHECK((there.covariance - here.covariance).norm() < 1e-6);
  }
}

TEST_CASE("a wrong pair of a cycle is overruled by the others") {
  const std::vector<MapPair> pairs{accepted(0, 1, {1, 0, 0}, 0.98), accepted(1, 2, {1, 0, 0}, 0.98),
                                   accepted(2, 3, {1, 0, 0}, 0.95), accepted(1, 3, {2, 0, 0}, 0.95),
                                   accepted(0, 3, {-30, 4, 2}, 0.97)};
  const PlacementResult placed = placeMaps(points(4), pairs);
  REQUIRE(placed.groups.size() == 1);
  checkPose(placed.maps[3].pose, {3, 0, 0}, 1e-6);
  REQUIRE(placed.settlements[4]);
  CHECK_FALSE(placed.settlements[4]->agrees);
  CHECK(placed.settlements[4]->distance > 30);
  CHECK(placed.settlements[4]->information.norm() == 0);
  CHECK(placed.settlements[3]->agrees);
  CHECK(placed.settlements[3]->distance < 1e-6);
}

TEST_CASE("a map that came in by a wrong pair moves to where the others want it") {
  // The wrong pair (0, 4) is the surest of all and so joins first.
  std::vector<MapPair> pairs{accepted(0, 4, {-30, 4, 2}, 0.9995)};
  for (int a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b) {
      pairs.push_back(accepted(a, b, {1.0 * (b - a), 0, 0}, 0.999));
    }
    if (a > 0) {
      pairs.push_back(accepted(a, 4, {4.0 - a, 0, 0}, 0.95));
    }
  }
  const PlacementResult placed = placeMaps(points(5), pairs);
  REQUIRE(placed.groups.size() == 1);
  checkPose(placed.maps[4].pose, {4, 0, 0}, 1e-6);
  CHECK_FALSE(placed.settlements[0]->agrees);
}

TEST_CASE("a pair that alone is ambiguous is settled by two others") {
  std::vector<MapPair> pairs{accepted(0, 1, {5, 0, 0}, 0.9), accepted(1, 2, {5, 0, 0}, 0.9),
                             accepted(0, 2, {30, 0, 0}, 0.5)};
  pairs[2].result.verdict = Verdict::Ambiguous;
  pairs[2].result.alternatives = {{{10, 0.2, 0}, 0.4}};
  const PlacementResult placed = placeMaps(points(3), pairs);
  REQUIRE(placed.groups.size() == 1);
  CHECK(placed.maps[2].pose.x == Approx(10).margin(0.1));
  REQUIRE(placed.settlements[2]);
  CHECK(placed.settlements[2]->agrees);
  CHECK(placed.settlements[2]->candidate == 1);
  CHECK(placed.maps[2].pose.y > 0.001);
}

TEST_CASE("two ambiguous pairs that agree on one pose place a map that neither could") {
  std::vector<MapPair> pairs{accepted(0, 1, {5, 0, 0}, 0.995)};
  for (const MapPair& pair : {accepted(0, 2, {30, 0, 0}, 0.5), accepted(1, 2, {-9, 7, 1}, 0.5)}) {
    pairs.push_back(pair);
    pairs.back().result.verdict = Verdict::Ambiguous;
  }
  CHECK(placeMaps(points(3), pairs).groups.size() == 2);
  pairs[1].result.alternatives = {{{10, 0, 0}, 0.45}};
  pairs[2].result.alternatives = {{{5, 0, 0}, 0.45}};
  const PlacementResult placed = placeMaps(points(3), pairs);
  REQUIRE(placed.groups.size() == 1);
  checkPose(placed.maps[2].pose, {10, 0, 0}, 1e-6);
}

TEST_CASE("two buildings are not glued by one pair, but by two that agree") {
  std::vector<MapPair> pairs{accepted(0, 1, {1, 0, 0}, 0.999), accepted(2, 3, {1, 0, 0}, 0.999),
                             accepted(1, 2, {1, 0, 0}, 0.9)};
  CHECK(placeMaps(points(4), pairs).groups.size() == 2);
  SECTION("of overwhelming confidence") {
    pairs[2].result.confidence = 0.999;
    CHECK(placeMaps(points(4), pairs).groups.size() == 1);
  }
  SECTION("that agree") {
    pairs.push_back(accepted(0, 3, {3, 0, 0}, 0.9));
    const PlacementResult placed = placeMaps(points(4), pairs);
    REQUIRE(placed.groups.size() == 1);
    checkPose(placed.maps[3].pose, {3, 0, 0}, 1e-6);
  }
  SECTION("that disagree") {
    pairs.push_back(accepted(0, 3, {3, 9, 0}, 0.9));
    CHECK(placeMaps(points(4), pairs).groups.size() == 2);
  }
}

TEST_CASE("pairs that see one place only are one witness") {
  // Four rooms of 4 m x 4 m; that of maps 0 and 1 is taken for that of 2 and 3, twice.
  const std::vector<Footprint> rooms(4, squareRoom());
  const std::vector<MapPair> pairs{accepted(0, 1, {0, 0, 0}, 0.999),
                                   accepted(2, 3, {0, 0, 0}, 0.999), accepted(0, 2, {0, 0, 0}, 0.9),
                                   accepted(1, 3, {0, 0, 0}, 0.9)};
  CHECK(placeMaps(rooms, pairs).groups.size() == 2);
  CHECK(placeMaps(points(4), pairs).groups.size() == 1);
}

TEST_CASE("pairs that should have been found but were not speak against a map's place") {
  // Map 3 would lie on all three others, yet only one of them matches it.
  std::vector<MapPair> pairs{accepted(0, 1, {0, 0, 0}, 0.999), accepted(1, 2, {0, 0, 0}, 0.999),
                             accepted(0, 3, {0, 0, 0}, 0.75)};
  for (const int a : {1, 2}) {
    pairs.push_back(rejected(a, 3));
    pairs.back().result.confidence = 0.01;
  }
  CHECK(placeMaps(std::vector<Footprint>(4, squareRoom()), pairs).groups.size() == 2);
  CHECK(placeMaps(points(4), pairs).groups.size() == 1);
}

TEST_CASE("more agreeing pairs make a pose surer, and a longer way less sure") {
  std::vector<MapPair> pairs{accepted(0, 1, {1, 0, 0}, 0.99), accepted(1, 2, {1, 0, 0}, 0.99)};
  const PlacementResult chain = placeMaps(points(3), pairs);
  CHECK(chain.maps[2].covariance.trace() > chain.maps[1].covariance.trace());
  CHECK(chain.maps[1].covariance.trace() > 0);
  pairs.push_back(accepted(0, 2, {2, 0, 0}, 0.99));
  CHECK(placeMaps(points(3), pairs).maps[2].covariance.trace() < chain.maps[2].covariance.trace());
}

TEST_CASE("covariances along a chain agree with numeric derivatives") {
  const std::array<Pose2D, 2> edges{Pose2D{1.5, -0.7, 0.8}, Pose2D{2.0, 0.3, -1.9}};
  const PlacementResult placed =
      placeMaps(points(3), {accepted(0, 1, edges[0], 0.9), accepted(1, 2, edges[1], 0.8)});
  const Eigen::Matrix3d edge_covariance = Eigen::Vector3d(0.01, 0.02, 0.001).asDiagonal();
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  for (size_t edge = 0; edge < 2; ++edge) {
    Eigen::Matrix3d jacobian;
    for (int column = 0; column < 3; ++column) {
      const double step = 1e-6;
      std::array<Pose2D, 2> moved = edges;
      moved[edge][static_cast<size_t>(column)] += step;
      const Pose2D before = edges[0] + edges[1], after = moved[0] + moved[1];
      jacobian.col(column) = Eigen::Vector3d(after.x - before.x, after.y - before.y,
                                             wrapAngle(after.phi - before.phi)) /
                             step;
    }
    expected += jacobian * edge_covariance * jacobian.transpose();
  }
  CHECK((placed.maps[2].covariance - expected).norm() < 1e-6);
}

TEST_CASE("placement refuses indices that do not exist") {
  CHECK_THROWS_AS(placeMaps(points(0), {}), std::invalid_argument);
  CHECK_THROWS_AS(placeMaps(points(2), {accepted(0, 2, {}, 1)}), std::invalid_argument);
  CHECK_THROWS_AS(placeMaps(points(2), {}, 2), std::invalid_argument);
}
