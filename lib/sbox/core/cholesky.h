// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace sbox {

// Eigen's decomposition, compiled once for matrices of all sizes: each size of its own takes a
// second to compile.

/// L of `matrix` = L L^T, lower triangular. Of `matrix`, symmetric and positive definite, only the
/// lower triangle is read.
[[nodiscard]] Eigen::MatrixXd choleskyFactor(const Eigen::MatrixXd& matrix);

/// x of `matrix` x = `right`, where `matrix` is as above.
[[nodiscard]] Eigen::MatrixXd solvePositiveDefinite(const Eigen::MatrixXd& matrix,
                                                    const Eigen::MatrixXd& right);

}  // namespace sbox
