// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/edge_residual.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "sbox/core/cholesky.h"
#include "sbox/core/pose_errors.h"

namespace sbox {
namespace {

/// What makes the logarithm of a shift: half the turn over its tangent; and its derivative by the
/// turn.
struct Along {
  double value, by_turn;
};

Along alongOf(double half) {
  if (std::abs(half) < 1e-4) {
    return {1 - half * half / 3, -half / 3};
  }
  const double c = std::cos(half), s = std::sin(half);
  return {half * c / s, (c * s - half) / (2 * s * s)};
}

}  // namespace

EdgeResidual::EdgeResidual(const Pose2D& pose_b_in_a, const PoseCovariance& covariance)
    : heading_(pose_b_in_a.phi) {
  const Eigen::Matrix3d turn = turnedAxes(-heading_);
  place_along_b_ = turn.topLeftCorner<2, 2>() * Eigen::Vector2d(pose_b_in_a.x, pose_b_in_a.y);
  const Eigen::Matrix3d root = choleskyFactor(turn * covariance * turn.transpose());
  whitening_ = root.inverse();
}

/// From the edge's b to node b, along the axes of the edge's b.
struct EdgeResidual::Gap {
  Eigen::Rotation2Dd to_edge;  ///< From the axes that nodes are in.
  Eigen::Vector2d apart;       ///< Node b from node a.
  Eigen::Vector2d shift;
  double turn;
};

EdgeResidual::Gap EdgeResidual::gapBetween(const Eigen::Vector3d& a,
                                           const Eigen::Vector3d& b) const {
  const Eigen::Rotation2Dd to_edge(-(a.z() + heading_));
  const Eigen::Vector2d apart = to_edge * (b.head<2>() - a.head<2>());
  return {to_edge, apart, apart - place_along_b_, wrapAngle(b.z() - a.z() - heading_)};
}

Eigen::Vector3d EdgeResidual::at(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  const Gap gap = gapBetween(a, b);
  const double half = gap.turn / 2, along = alongOf(half).value;
  return whitening_ * Eigen::Vector3d(along * gap.shift.x() + half * gap.shift.y(),
                                      along * gap.shift.y() - half * gap.shift.x(), gap.turn);
}

EdgeJacobians EdgeResidual::jacobiansAt(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  const Gap gap = gapBetween(a, b);
  const double half = gap.turn / 2;
  const Along along = alongOf(half);
  Eigen::Matrix3d by_gap;
  by_gap << along.value, half, along.by_turn * gap.shift.x() + gap.shift.y() / 2,  //
      -half, along.value, along.by_turn * gap.shift.y() - gap.shift.x() / 2,       //
      0, 0, 1;
  const Eigen::Matrix3d gap_by_b = turnedAxes(gap.to_edge.angle());
  Eigen::Matrix3d gap_by_a = -gap_by_b;
  gap_by_a(0, 2) = gap.apart.y();
  gap_by_a(1, 2) = -gap.apart.x();
  const Eigen::Matrix3d whitened = whitening_ * by_gap;
  return {whitened * gap_by_a, whitened * gap_by_b};
}

}  // namespace sbox
