// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/pose.h"

#include <cmath>

namespace sbox {

double wrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2 * M_PI);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

Pose2D inverse(const Pose2D& pose_b_in_a) {
  const double c = std::cos(pose_b_in_a.phi), s = std::sin(pose_b_in_a.phi);
  return {-c * pose_b_in_a.x - s * pose_b_in_a.y, s * pose_b_in_a.x - c * pose_b_in_a.y,
          wrapAngle(-pose_b_in_a.phi)};
}

PoseCovariance inverseCovariance(const Pose2D& pose_b_in_a, const PoseCovariance& covariance) {
  // d(-R^T t) / d(t, phi): -R^T, and the derivative of R^T turned by phi.
  const double c = std::cos(pose_b_in_a.phi), s = std::sin(pose_b_in_a.phi);
  const double x = pose_b_in_a.x, y = pose_b_in_a.y;
  Eigen::Matrix3d jacobian;
  jacobian << -c, -s, s * x - c * y,  //
      s, -c, c * x + s * y,           //
      0, 0, -1;
  return jacobian * covariance * jacobian.transpose();
}

}  // namespace sbox
