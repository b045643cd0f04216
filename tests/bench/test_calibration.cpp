// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox-bench/calibration.h"

using namespace sbox;
using namespace sbox::bench;

namespace {

Answer answerWith(double confidence, bool right, bool accepted) {
  Answer answer;
  answer.result.has_pose = true;
  answer.result.confidence = confidence;
  answer.result.verdict = accepted ? Verdict::Accepted : Verdict::Rejected;
  answer.error = PoseError{0, 0, right};
  return answer;
}

}  // namespace

TEST_CASE("confidences are binned with what was right", "[bench][calibration]") {
  const Answer answers[] = {answerWith(0.05, false, false), answerWith(0.92, true, true),
                            answerWith(0.94, false, true), answerWith(1.0, true, true), Answer{}};
  std::vector<const Answer*> list;
  for (const Answer& answer : answers) {
    list.push_back(&answer);
  }
  const Reliability all = reliability(list);
  CHECK(all.answers == 4);  // The last has no pose.
  CHECK(all.brier == Approx((0.05 * 0.05 + 0.08 * 0.08 + 0.94 * 0.94) / 4));
  int counted = 0;
  for (const ReliabilityBin& bin : all.bins) {
    counted += bin.answers;
    if (bin.from == 0.9) {
      CHECK(bin.answers == 2);
      CHECK(bin.right == 1);
      CHECK(bin.accepted == 2);
      CHECK(bin.accepted_right == 1);
      CHECK(bin.mean_confidence == Approx(0.93));
    }
  }
  CHECK(counted == 4);
  CHECK(all.bins.front().answers == 1);
  CHECK(all.bins.back().answers == 1);
  CHECK(std::isnan(reliability({}).brier));
}

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
    sum += normalisedError(result, truth, {3, 8}).value();
  }
  CHECK(sum / kDraws == Approx(3).margin(0.15));
}

TEST_CASE("an unknown covariance has no normalised error", "[bench][calibration]") {
  PairResult result;
  result.has_pose = true;
  CHECK_FALSE(normalisedError(result, {}, {0, 0}).has_value());
  result.covariance.setZero();
  CHECK_FALSE(normalisedError(result, {}, {0, 0}).has_value());
  result.covariance.setIdentity();
  CHECK(normalisedError(result, {2, 0, 0}, {0, 0}).value() == Approx(4));
}
