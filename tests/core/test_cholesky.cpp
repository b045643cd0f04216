// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <random>

#include "catch.h"
#include "sbox/core/cholesky.h"

using sbox::choleskyFactor;
using sbox::solvePositiveDefinite;

TEST_CASE("Cholesky factors multiply to the matrix, of which only one triangle is read", "[core]") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const int size : {1, 2, 3, 30}) {
    const Eigen::MatrixXd root =
        Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
    const Eigen::MatrixXd matrix = root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
    Eigen::MatrixXd lower = matrix;
    lower.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);

    const Eigen::MatrixXd factor = choleskyFactor(lower);
    CHECK((factor * factor.transpose()).isApprox(matrix));
    CHECK(factor.isLowerTriangular(0));

    const Eigen::MatrixXd right =
        Eigen::MatrixXd::NullaryExpr(size, 2, [&] { return normal(random); });
    CHECK(solvePositiveDefinite(lower, right).isApprox(matrix.inverse() * right, 1e-9));
  }
}
