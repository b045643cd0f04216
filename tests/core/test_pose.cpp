// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox/core/pose.h"

using namespace sbox;

TEST_CASE("inverse undoes a pose", "[pose]") {
  const Pose2D pose_b_in_a(3, -2, 2.5);
  const Pose2D identity = pose_b_in_a + inverse(pose_b_in_a);
  CHECK(identity.x == Approx(0).margin(1e-12));
  CHECK(identity.y == Approx(0).margin(1e-12));
  CHECK(wrapAngle(identity.phi) == Approx(0).margin(1e-12));
}

TEST_CASE("wrapAngle folds into (-pi, pi]", "[pose]") {
  CHECK(wrapAngle(3 * M_PI) == Approx(M_PI));
  CHECK(wrapAngle(-M_PI) == Approx(M_PI));
  CHECK(wrapAngle(-7.0) == Approx(-7.0 + 2 * M_PI));
}

TEST_CASE("inverseCovariance agrees with numeric differentiation", "[pose]") {
  const Pose2D pose(4, 1, 0.7);
  Eigen::Matrix3d jacobian;
  const double step = 1e-6;
  for (int i = 0; i < 3; ++i) {
    Pose2D moved = pose;
    moved[static_cast<size_t>(i)] += step;
    const Pose2D from = inverse(pose), to = inverse(moved);
    jacobian.col(i) << (to.x - from.x) / step, (to.y - from.y) / step, (to.phi - from.phi) / step;
  }
  Eigen::Matrix3d covariance;
  covariance << 0.04, 0.01, 0.001, 0.01, 0.09, -0.002, 0.001, -0.002, 0.0004;
  const Eigen::Matrix3d expected = jacobian * covariance * jacobian.transpose();
  CHECK((inverseCovariance(pose, covariance) - expected).norm() < 1e-6);
}
