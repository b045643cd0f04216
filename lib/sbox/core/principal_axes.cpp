// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/principal_axes.h"

#include <cmath>

namespace sbox {

PrincipalAxes principalAxes(const Eigen::Matrix2d& symmetric) {
  const double mean = (symmetric(0, 0) + symmetric(1, 1)) / 2;
  const double half_difference = (symmetric(0, 0) - symmetric(1, 1)) / 2;
  const double radius = std::hypot(half_difference, symmetric(1, 0));
  const double angle_of_largest = std::atan2(symmetric(1, 0), half_difference) / 2;
  return {mean + radius, mean - radius, {-std::sin(angle_of_largest), std::cos(angle_of_largest)}};
}

}  // namespace sbox
