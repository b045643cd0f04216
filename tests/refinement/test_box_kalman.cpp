// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <random>

#include "catch.h"
#include "sbox/refinement/box_kalman.h"

using namespace sbox;

namespace {

const RigidTransform truth{0.3, {4, -2}};
const Eigen::Vector2d pivot(5, 5);

/// Corners of a building of 10 m, laid into map a by the truth with this noise.
std::vector<CornerPair> cornersWithNoise(double noise) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, noise);
  std::vector<CornerPair> corners;
  for (const double x : {0.0, 4.0, 10.0}) {
    for (const double y : {0.0, 7.0, 10.0}) {
      const Eigen::Vector2d in_b(x, y);
      const Eigen::Vector2d off(normal(random), normal(random));
      corners.push_back({truth * in_b + off, in_b, 0.0625 * Eigen::Matrix2d::Identity()});
    }
  }
  return corners;
}

/// A prediction that is known no better than the guess is good.
BoxKalmanOptions vague() {
  BoxKalmanOptions options;
  options.prediction_shift = 1.0;
  options.prediction_turn = 3.0;
  return options;
}

RigidTransform guess() {
  return {truth.heading + 0.02, truth.translation + Eigen::Vector2d(0.3, -0.2)};
}

}  // namespace

TEST_CASE("exact corners bring the state to the truth") {
  const auto result = filterCorners(cornersWithNoise(0), guess(), pivot, vague());
  REQUIRE(result.has_value());
  CHECK(result->used == 9);
  CHECK(((result->b_in_a * pivot) - (truth * pivot)).norm() < 0.02);
  CHECK(result->b_in_a.heading == Approx(truth.heading).margin(0.002));
}

TEST_CASE("noisy corners do better than the guess, and the covariance is no larger than before") {
  const auto result = filterCorners(cornersWithNoise(0.1), guess(), pivot, vague());
  REQUIRE(result.has_value());
  CHECK(((result->b_in_a * pivot) - (truth * pivot)).norm() < 0.15);
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(result->covariance).eigenvalues();
  CHECK(values.minCoeff() > 0);
  CHECK(result->covariance(0, 0) < 1.0);
}

TEST_CASE("a corner far off is left out, and none left is no answer") {
  std::vector<CornerPair> corners = cornersWithNoise(0);
  corners[4].in_a += Eigen::Vector2d(6, 6);
  const auto result = filterCorners(corners, guess(), pivot, vague());
  REQUIRE(result.has_value());
  CHECK(result->used == 8);
  CHECK(((result->b_in_a * pivot) - (truth * pivot)).norm() < 0.02);
  CHECK_FALSE(filterCorners({}, guess(), pivot, vague()).has_value());
}
