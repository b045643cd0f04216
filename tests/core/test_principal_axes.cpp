// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/core/principal_axes.h"

using sbox::PrincipalAxes;
using sbox::principalAxes;

TEST_CASE("principal axes are those of Eigen's solver", "[core]") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    Eigen::Matrix2d root;
    root << normal(random), normal(random), normal(random), normal(random);
    const Eigen::Matrix2d scatter = root * root.transpose();
    const PrincipalAxes axes = principalAxes(scatter);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter);
    CHECK(axes.smallest == Approx(solver.eigenvalues()[0]).margin(1e-12));
    CHECK(axes.largest == Approx(solver.eigenvalues()[1]));
    CHECK(std::abs(axes.smallest_axis.dot(solver.eigenvectors().col(0))) == Approx(1));
  }
}

TEST_CASE("principal axes of lines and of what has none", "[core]") {
  Eigen::Matrix2d along_x, along_y;
  along_x << 4, 0, 0, 1;
  along_y << 1, 0, 0, 4;
  CHECK(std::abs(principalAxes(along_x).smallest_axis.y()) == Approx(1));
  CHECK(std::abs(principalAxes(along_y).smallest_axis.x()) == Approx(1));
  const PrincipalAxes of_circle = principalAxes(3 * Eigen::Matrix2d::Identity());
  CHECK(of_circle.smallest == 3);
  CHECK(of_circle.largest == 3);
  CHECK(of_circle.smallest_axis.norm() == Approx(1));
  CHECK(principalAxes(Eigen::Matrix2d::Zero()).largest == 0);
}
