// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How small errors (x, y, phi) of a pose, and with them its covariance, look from elsewhere.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace sbox {

/// Takes errors of a pose to those of the point at `arm` (metres, along the axes that the errors
/// are along) from it: a turn moves what lies far off. With -arm the way back.
[[nodiscard]] inline Eigen::Matrix3d leverTo(const Eigen::Vector2d& arm) {
  Eigen::Matrix3d lever = Eigen::Matrix3d::Identity();
  lever(0, 2) = -arm.y();
  lever(1, 2) = arm.x();
  return lever;
}

/// Takes errors along the axes of a frame to those along the axes of another, in which the first is
/// turned by `phi` radians.
[[nodiscard]] inline Eigen::Matrix3d turnedAxes(double phi) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(phi).toRotationMatrix();
  return turn;
}

}  // namespace sbox
