// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/normalised_error.h"

#include <Eigen/Cholesky>

#include "sbox/core/pose_errors.h"

namespace sbox::bench {

std::optional<NormalisedError> normalisedError(const PairResult& result,
                                               const AnnotatedTruth& truth) {
  if (!result.has_pose || result.covariance == PairResult{}.covariance) {
    return std::nullopt;
  }
  const Pose2D& pose = result.pose_b_in_a;
  const Point2D placed = pose.composePoint(truth.centre_in_b);
  const Point2D true_place = truth.pose_b_in_a.composePoint(truth.centre_in_b);
  const Eigen::Vector3d error(placed.x - true_place.x, placed.y - true_place.y,
                              wrapAngle(pose.phi - truth.pose_b_in_a.phi));
  // d(placed) / d(x, y, phi): a turn moves the centre across its arm.
  const Eigen::Matrix3d jacobian = leverTo({placed.x - pose.x, placed.y - pose.y});
  const Eigen::Matrix3d covariance = jacobian * result.covariance * jacobian.transpose();
  const Eigen::LLT<Eigen::Matrix3d> of_answer(covariance);
  if (of_answer.info() != Eigen::Success) {
    return std::nullopt;
  }
  const Eigen::LLT<Eigen::Matrix3d> of_difference(covariance + truth.covariance);
  return NormalisedError{error.dot(of_answer.solve(error)), error.dot(of_difference.solve(error))};
}

}  // namespace sbox::bench
