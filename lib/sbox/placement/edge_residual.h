// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where an edge of the pose graph says that node b lies against where it does: the logarithm of the
// transform from one to the other, in standard deviations. Unlike a difference of coordinates it is
// the same for the inverse edge, so that the order of the maps does not matter.
#pragma once

#include <Eigen/Core>

#include "sbox/core/pose.h"

namespace sbox {

/// Derivatives of a residual.
struct EdgeJacobians {
  Eigen::Matrix3d by_a;  ///< By (x, y, phi) of node a.
  Eigen::Matrix3d by_b;  ///< By that of node b.
};

/// The residual of one edge, wherever its nodes are.
class EdgeResidual {
 public:
  /// `covariance`: of `pose_b_in_a`, positive definite.
  EdgeResidual(const Pose2D& pose_b_in_a, const PoseCovariance& covariance);

  /// Its squared length is the squared distance between edge and nodes. `a`, `b`: (x, y, phi) of
  /// the nodes.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  /// How that changes with the nodes.
  [[nodiscard]] EdgeJacobians jacobiansAt(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

 private:
  struct Gap;
  [[nodiscard]] Gap gapBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  double heading_;                 ///< Of the edge's b in a, radians.
  Eigen::Vector2d place_along_b_;  ///< Of the edge's b in a, along the axes of b.
  Eigen::Matrix3d whitening_;      ///< L^-1, where L L^T is the covariance along the axes of b.
};

}  // namespace sbox
