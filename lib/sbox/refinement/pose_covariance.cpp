// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/pose_covariance.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace sbox {
namespace {

constexpr double kUnknownShift = 30;  // Metres: what is not known at all.
constexpr double kUnknownTurn = 1;    // Radians.

/// The middle of the walls: about it, shift and turn are independent. The matrix takes errors of
/// the pivot to errors of that middle.
Eigen::Matrix3d toMiddle(const Eigen::Matrix3d& information) {
  constexpr double ridge = 1e-9;
  const Eigen::Matrix2d shifts =
      information.topLeftCorner<2, 2>() + ridge * Eigen::Matrix2d::Identity();
  Eigen::Matrix3d lever = Eigen::Matrix3d::Identity();
  lever.topRightCorner<2, 1>() = shifts.inverse() * information.topRightCorner<2, 1>();
  return lever;
}

}  // namespace

Eigen::Matrix3d poseCovariance(const Eigen::Matrix3d& information, double roughness,
                               const CovarianceOptions& options) {
  const Eigen::Matrix3d to_middle = toMiddle(information);
  const Eigen::Matrix3d to_pivot = to_middle.inverse();
  const Eigen::Matrix3d about_middle = to_pivot.transpose() * information * to_pivot;
  const Eigen::Vector3d unknown(1 / (kUnknownShift * kUnknownShift),
                                1 / (kUnknownShift * kUnknownShift),
                                1 / (kUnknownTurn * kUnknownTurn));
  Eigen::Matrix3d weight =
      about_middle / (options.correlation_length * options.wall_noise * options.wall_noise);
  weight.diagonal() += unknown;
  Eigen::Matrix3d covariance = weight.inverse();

  constexpr double least_wall = 5, usual_wall = 50;  // Metres.
  const double wall = about_middle(0, 0) + about_middle(1, 1);
  const double scarcity = usual_wall / std::max(wall, least_wall);
  const double spread = std::sqrt(std::max(about_middle(2, 2), 0.0) / std::max(wall, least_wall));
  const double shift = std::min(
      options.drift_shift * roughness * roughness * std::pow(scarcity, 1.5), kUnknownShift);
  const double turn =
      std::min(options.drift_turn * std::pow(roughness, 1.5) * scarcity / std::max(spread, 0.1),
               kUnknownTurn);
  covariance.diagonal() += Eigen::Vector3d(shift * shift, shift * shift, turn * turn);
  return to_pivot * covariance * to_pivot.transpose();
}

}  // namespace sbox
