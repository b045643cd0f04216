// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/mapping/sound_pose.h"

#include <Eigen/LU>
#include <cmath>

namespace sbox {

bool isSound(const mrpt::poses::CPose3D& pose) {
  constexpr double rounding = 1e-3;
  const Eigen::Matrix3d turn = pose.getRotationMatrix().asEigen();
  return std::isfinite(pose.x() + pose.y() + pose.z()) &&
         (turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm() <= rounding &&
         turn.determinant() > 0;
}

}  // namespace sbox
