// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/cholesky.h"

#include <Eigen/Cholesky>

namespace sbox {

Eigen::MatrixXd choleskyFactor(const Eigen::MatrixXd& matrix) { return matrix.llt().matrixL(); }

Eigen::MatrixXd solvePositiveDefinite(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.llt().solve(right);
}

}  // namespace sbox
