// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <stdexcept>

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
  MapPair pair = accepted(a, b, {9, 9, 1}, 0.99);
  pair.result.verdict = Verdict::Rejected;
  return pair;
}

void checkPose(const Pose2D& pose, const Pose2D& expected) {
  CHECK(pose.x == Approx(expected.x).margin(1e-12));
  CHECK(pose.y == Approx(expected.y).margin(1e-12));
  CHECK(pose.phi == Approx(expected.phi).margin(1e-12));
}

}  // namespace

TEST_CASE("poses are composed along a chain of maps") {
  // Quarter turns: b lies at (1, 0) turned left, c two metres ahead of b.
  const PlacementResult placed =
      placeMaps(3, {accepted(0, 1, {1, 0, M_PI / 2}, 0.9), accepted(1, 2, {2, 0, M_PI / 2}, 0.8)});
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
  const PlacementResult placed = placeMaps(3, pairs, 2);
  CHECK(placed.groups[0].reference == 2);
  checkPose(placed.maps[2].pose, {0, 0, 0});
  checkPose(placed.maps[0].pose, {1, 2, M_PI});
}

TEST_CASE("of a cycle the most confident pairs are used") {
  const std::vector<MapPair> pairs{accepted(0, 1, {1, 0, 0}, 0.9), accepted(0, 2, {50, 50, 1}, 0.5),
                                   accepted(1, 2, {1, 0, 0}, 0.8)};
  checkPose(placeMaps(3, pairs).maps[2].pose, {2, 0, 0});
}

TEST_CASE("only accepted pairs of enough confidence join maps") {
  const std::vector<MapPair> pairs{rejected(0, 1), accepted(1, 2, {1, 0, 0}, 0.6), rejected(0, 2),
                                   accepted(2, 3, {1, 0, 0}, 0.4)};
  const PlacementResult placed = placeMaps(4, pairs);
  REQUIRE(placed.groups.size() == 2);
  CHECK(placed.groups[0].members == std::vector<int>{0});
  CHECK(placed.groups[1].members == std::vector<int>{1, 2, 3});
  CHECK(placed.largest == 1);
  CHECK(placed.maps[0].group == 0);
  CHECK(placed.maps[3].group == 1);
  CHECK(placed.groups[1].reference == 1);
  CHECK(placeMaps(4, pairs, {}, {0.5}).groups.size() == 3);
}

TEST_CASE("the order of the pairs changes nothing") {
  std::vector<MapPair> pairs{accepted(0, 1, {1, 0, 0.1}, 0.7), accepted(0, 2, {2, 0, 0.2}, 0.7),
                             accepted(1, 2, {3, 0, 0.3}, 0.7), accepted(2, 3, {4, 0, 0.4}, 0.7)};
  const PlacementResult placed = placeMaps(4, pairs);
  std::reverse(pairs.begin(), pairs.end());
  const PlacementResult again = placeMaps(4, pairs);
  for (size_t i = 0; i < 4; ++i) {
    CHECK(again.maps[i].pose.x == placed.maps[i].pose.x);
    CHECK(again.maps[i].pose.y == placed.maps[i].pose.y);
    CHECK(again.maps[i].pose.phi == placed.maps[i].pose.phi);
  }
}

TEST_CASE("covariances along a chain agree with numeric derivatives") {
  const std::array<Pose2D, 2> edges{Pose2D{1.5, -0.7, 0.8}, Pose2D{2.0, 0.3, -1.9}};
  const PlacementResult placed =
      placeMaps(3, {accepted(0, 1, edges[0], 0.9), accepted(1, 2, edges[1], 0.8)});
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
  CHECK_THROWS_AS(placeMaps(0, {}), std::invalid_argument);
  CHECK_THROWS_AS(placeMaps(2, {accepted(0, 2, {}, 1)}), std::invalid_argument);
  CHECK_THROWS_AS(placeMaps(2, {}, 2), std::invalid_argument);
}
