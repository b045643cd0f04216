// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "catch.h"
#include "sbox-bench/normalised_error.h"

using namespace sbox;
using namespace sbox::bench;

TEST_CASE("the normalised error of honest poses averages three", "[bench][calibration]") {
  // Poses drawn from their own covariance, which ties x and y to a turn about a far point.
  Eigen::Matrix3d spread;
  spread << 0.1, 0, 0, 0.03, 0.05, 0, 0.002, -0.004, 0.003;
  const Pose2D truth(4, -2, 1.2);
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  double sum = 0;
  constexpr int kDraws = 4000;
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d e =
        spread * Eigen::Vector3d(normal(random), normal(random), normal(random));
    PairResult result;
    result.has_pose = true;
    result.pose_b_in_a = {truth.x + e.x(), truth.y + e.y(), truth.phi + e.z()};
    result.covariance = spread * spread.transpose();
    sum += normalisedError(result, {truth, {3, 8}}).value().of_answer;
  }
  CHECK(sum / kDraws == Approx(3).margin(0.15));
}

TEST_CASE("an unknown covariance has no normalised error", "[bench][calibration]") {
  PairResult result;
  result.has_pose = true;
  CHECK_FALSE(normalisedError(result, {}).has_value());
  result.covariance.setZero();
  CHECK_FALSE(normalisedError(result, {}).has_value());
  result.covariance.setIdentity();
  CHECK(normalisedError(result, {{2, 0, 0}, {0, 0}}).value().of_answer == Approx(4));
}

TEST_CASE("the error of the truth takes its part of the error of the answer", "[bench]") {
  PairResult result;
  result.has_pose = true;
  result.covariance.setIdentity();
  AnnotatedTruth truth;
  truth.pose_b_in_a = {2, 0, 0};
  truth.covariance.diagonal() << 3, 0, 0;
  const NormalisedError error = normalisedError(result, truth).value();
  CHECK(error.of_answer == Approx(4));
  CHECK(error.of_difference == Approx(1));
}
