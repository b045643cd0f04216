// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/annotated_truth.h"

#include <Eigen/LU>

#include "sbox-bench/judge.h"

namespace sbox::bench {

AnnotatedTruth annotatedTruth(const AnnotatedPair& pair, double resolution,
                              const Pose2D& corner_in_a, const Pose2D& corner_in_b) {
  const size_t count = pair.points_b.size();
  AnnotatedTruth truth;
  truth.pose_b_in_a =
      poseFromCorners(trueCornerAInCornerB(pair, resolution), corner_in_a, corner_in_b);
  Point2D mean(0, 0);
  for (const Point2D& point : pair.points_b) {
    mean += point * (resolution / static_cast<double>(count));
  }
  truth.centre_in_b = corner_in_b.composePoint(mean);
  const Point2D centre = truth.pose_b_in_a.composePoint(truth.centre_in_b);
  // The normal equations of the fit about the centre, and what it leaves.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double residuals = 0;
  for (size_t i = 0; i < count; ++i) {
    const Point2D from_b =
        truth.pose_b_in_a.composePoint(corner_in_b.composePoint(pair.points_b[i] * resolution));
    const Point2D arm = from_b - centre;
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian << 1, 0, -arm.y, 0, 1, arm.x;
    information += jacobian.transpose() * jacobian;
    residuals += (corner_in_a.composePoint(pair.points_a[i] * resolution) - from_b).sqrNorm();
  }
  constexpr double fitted = 3;
  const double freedom = 2 * static_cast<double>(count) - fitted;
  if (freedom > 0) {
    truth.covariance = residuals / freedom * information.inverse();
  }
  return truth;
}

}  // namespace sbox::bench
