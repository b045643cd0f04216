// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/placement/edge_residual.h"

using namespace sbox;

TEST_CASE("derivatives of an edge's residual are those by differences", "[placement]") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto anywhere = [&] {
    return Eigen::Vector3d(5 * normal(random), 5 * normal(random), 2 * normal(random));
  };
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d root =
        Eigen::Matrix3d::NullaryExpr([&] { return 0.3 * normal(random); }) +
        Eigen::Matrix3d::Identity();
    const Eigen::Vector3d measured = anywhere();
    const EdgeResidual residual(Pose2D(measured.x(), measured.y(), measured.z()),
                                root * root.transpose());
    const Eigen::Vector3d a = anywhere();
    Eigen::Vector3d b = anywhere();
    if (i % 3 == 0) {
      b.z() = a.z() + measured.z() + 1e-6 * normal(random);  // Hardly any turn is left.
    }
    if (std::abs(wrapAngle(b.z() - a.z() - measured.z())) > 3) {
      continue;  // The residual jumps at half a turn.
    }
    const EdgeJacobians jacobians = residual.jacobiansAt(a, b);
    constexpr double step = 1e-6;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d moved = step * Eigen::Vector3d::Unit(k);
      const Eigen::Vector3d by_a =
          (residual.at(a + moved, b) - residual.at(a - moved, b)) / (2 * step);
      const Eigen::Vector3d by_b =
          (residual.at(a, b + moved) - residual.at(a, b - moved)) / (2 * step);
      CHECK((jacobians.by_a.col(k) - by_a).norm() < 1e-6 * (1 + by_a.norm()));
      CHECK((jacobians.by_b.col(k) - by_b).norm() < 1e-6 * (1 + by_b.norm()));
    }
  }
}
