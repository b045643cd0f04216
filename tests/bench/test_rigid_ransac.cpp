// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox-bench/methods/rigid_ransac.h"

using namespace sbox;
using namespace sbox::bench;

namespace {

/// `good` exact matches under the pose, then `bad` ones at random.
std::vector<PointMatch> matchesUnder(const Pose2D& pose_b_in_a, int good, int bad) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-20, 20);
  std::vector<PointMatch> matches;
  for (int i = 0; i < good + bad; ++i) {
    const Point2D in_b(place(random), place(random));
    const Point2D elsewhere(place(random), place(random));
    matches.push_back({i < good ? pose_b_in_a.composePoint(in_b) : elsewhere, in_b});
  }
  return matches;
}

}  // namespace

TEST_CASE("the pose is found among four times as many false matches", "[bench][rigid_ransac]") {
  for (const Pose2D& truth :
       {Pose2D(0, 0, 0), Pose2D(7, -3, 0), Pose2D(0, 0, 2.5), Pose2D(-12, 5, -1.7)}) {
    const RansacResult result = rigidRansac(matchesUnder(truth, 30, 120));
    CHECK(result.inliers.size() >= 30);
    CHECK(result.pose_b_in_a.x == Approx(truth.x).margin(0.2));
    CHECK(result.pose_b_in_a.y == Approx(truth.y).margin(0.2));
    CHECK(wrapAngle(result.pose_b_in_a.phi - truth.phi) == Approx(0).margin(0.02));
  }
}

TEST_CASE("the same matches give the same pose", "[bench][rigid_ransac]") {
  const std::vector<PointMatch> matches = matchesUnder({1, 2, 3}, 20, 60);
  const RansacResult one = rigidRansac(matches), two = rigidRansac(matches);
  CHECK(one.inliers == two.inliers);
  CHECK(one.pose_b_in_a.phi == two.pose_b_in_a.phi);
}

TEST_CASE("a mirrored or scaled copy does not pass for a rigid one", "[bench][rigid_ransac]") {
  std::vector<PointMatch> mirrored, scaled;
  for (const PointMatch& m : matchesUnder({}, 60, 0)) {
    mirrored.push_back({{-m.in_a.x, m.in_a.y}, m.in_b});
    scaled.push_back({m.in_a * 1.5, m.in_b});
  }
  CHECK(rigidRansac(mirrored).inliers.size() < 20);
  CHECK(rigidRansac(scaled).inliers.size() < 20);
}

TEST_CASE("too few matches have no pose", "[bench][rigid_ransac]") {
  CHECK(rigidRansac({}).inliers.empty());
  CHECK(rigidRansac({{{0, 0}, {0, 0}}}).inliers.empty());
}
