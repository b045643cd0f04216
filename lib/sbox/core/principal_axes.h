// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace sbox {

/// What a symmetric 2x2 matrix does along its axes: of a scatter of points, along the line that
/// fits them best and across it.
struct PrincipalAxes {
  double largest = 0;                                        ///< The larger eigenvalue.
  double smallest = 0;                                       ///< The smaller.
  Eigen::Vector2d smallest_axis = Eigen::Vector2d::UnitY();  ///< Its direction; either sign.
};

/// In closed form; only the lower triangle is read.
[[nodiscard]] PrincipalAxes principalAxes(const Eigen::Matrix2d& symmetric);

}  // namespace sbox
