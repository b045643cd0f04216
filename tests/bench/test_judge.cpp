// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox-bench/judge.h"

using namespace sbox;
using namespace sbox::bench;

namespace {

constexpr double kDegree = M_PI / 180;

/// Two points a hundred cells apart; b is a turned by 90 degrees, then moved by (10, 20) cells.
AnnotatedPair quarterTurnPair() {
  AnnotatedPair pair;
  pair.theta_deg = 90;
  pair.offset = {10, 20};
  pair.points_a = {{0, 0}, {100, 0}};
  pair.points_b = {{10, 20}, {10, 120}};
  pair.floor_cells = 2;
  return pair;
}

}  // namespace

TEST_CASE("the annotated transform is right with no error", "[bench][judge]") {
  const AnnotatedPair pair = quarterTurnPair();
  const auto error = poseError(pair, 0.05, trueCornerAInCornerB(pair, 0.05));
  REQUIRE(error.has_value());
  CHECK(error->right);
  CHECK(error->excess_cells == Approx(-2));
  CHECK(error->rotation_deg == Approx(0).margin(1e-9));
}

TEST_CASE("an offset is right up to 15 cells over the floor", "[bench][judge]") {
  const AnnotatedPair pair = quarterTurnPair();
  Pose2D pose = trueCornerAInCornerB(pair, 0.1);
  pose.x += 16.9 * 0.1;
  CHECK(poseError(pair, 0.1, pose)->right);
  CHECK(poseError(pair, 0.1, pose)->excess_cells == Approx(14.9));
  pose.x += 0.2 * 0.1;
  CHECK_FALSE(poseError(pair, 0.1, pose)->right);
}

TEST_CASE("a pair's own tolerance counts", "[bench][judge]") {
  AnnotatedPair pair = quarterTurnPair();
  Pose2D pose = trueCornerAInCornerB(pair, 0.05);
  pose.y += 20 * 0.05;
  CHECK_FALSE(poseError(pair, 0.05, pose)->right);
  pair.tolerance_cells = 18.1;
  CHECK(poseError(pair, 0.05, pose)->right);
}

TEST_CASE("rotation is right up to 5 degrees from either annotated angle", "[bench][judge]") {
  AnnotatedPair pair = quarterTurnPair();
  pair.tolerance_cells = 1000;
  Pose2D pose = trueCornerAInCornerB(pair, 0.05);
  pose.phi += 4.99 * kDegree;
  CHECK(poseError(pair, 0.05, pose)->right);
  pose.phi += 0.02 * kDegree;
  CHECK_FALSE(poseError(pair, 0.05, pose)->right);
  pair.theta_local = 92;
  CHECK(poseError(pair, 0.05, pose)->right);
  CHECK(poseError(pair, 0.05, pose)->rotation_deg == Approx(3.01));
}

TEST_CASE("angles compare across the half turn", "[bench][judge]") {
  AnnotatedPair pair = quarterTurnPair();
  pair.theta_deg = 179;
  CHECK(poseError(pair, 0.05, {0, 0, -179 * kDegree})->rotation_deg == Approx(2));
}

TEST_CASE("the outcome follows acceptance and truth", "[bench][judge]") {
  const AnnotatedPair pair = quarterTurnPair();
  AnnotatedPair negative;
  negative.negative = true;
  const auto right = poseError(pair, 0.05, trueCornerAInCornerB(pair, 0.05));
  const auto wrong = poseError(pair, 0.05, {});
  CHECK(judge(pair, true, right) == Outcome::Right);
  CHECK(judge(pair, true, wrong) == Outcome::Wrong);
  CHECK(judge(pair, true, std::nullopt) == Outcome::Wrong);
  CHECK(judge(pair, false, right) == Outcome::Refused);
  CHECK(judge(negative, true, std::nullopt) == Outcome::Wrong);
  CHECK(judge(negative, false, std::nullopt) == Outcome::Right);
  CHECK_FALSE(poseError(negative, 0.05, {}).has_value());
}

TEST_CASE("a pose between frames and one between corners are two views of one", "[bench][judge]") {
  const Pose2D corner_in_a(-3, 2, 0.3), corner_in_b(5, -7, -1.1), pose_b_in_a(1.5, -2.5, 2.2);
  const Pose2D corners = cornerTransform(pose_b_in_a, corner_in_a, corner_in_b);
  // One point, by way of the frames and by way of the corners.
  const Point2D from_corner_a(1, 2);
  const Point2D in_a = corner_in_a.composePoint(from_corner_a);
  const Point2D in_b = inverse(pose_b_in_a).composePoint(in_a);
  const Point2D from_corner_b = inverse(corner_in_b).composePoint(in_b);
  const Point2D direct = corners.composePoint(from_corner_a);
  CHECK(direct.x == Approx(from_corner_b.x));
  CHECK(direct.y == Approx(from_corner_b.y));
  const Pose2D back = poseFromCorners(corners, corner_in_a, corner_in_b);
  CHECK(back.x == Approx(pose_b_in_a.x));
  CHECK(back.y == Approx(pose_b_in_a.y));
  CHECK(wrapAngle(back.phi - pose_b_in_a.phi) == Approx(0).margin(1e-12));
}
