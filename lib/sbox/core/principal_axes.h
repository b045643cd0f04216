// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace sbox {

/// Eigenvalues of a symmetric 2x2 matrix, and the direction of the smaller: of a scatter of points,
/// the direction across the line that fits them best.
struct PrincipalAxes {
  double largest = 0;
  double smallest = 0;
  Eigen::Vector2d smallest_axis = Eigen::Vector2d::UnitY();  ///< Of length 1; either sign.
};

/// In closed form; only the lower triangle is read.
[[nodiscard]] PrincipalAxes principalAxes(const Eigen::Matrix2d& symmetric);

}  // namespace sbox
