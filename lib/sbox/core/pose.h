// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Poses and transforms of the plane, SE(2). A name says its frames: `pose_b_in_a` is the pose of
// frame b seen from frame a, so that p_a = pose_b_in_a.composePoint(p_b) and
// pose_c_in_a = pose_b_in_a + pose_c_in_b (MRPT's `+`).
#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <Eigen/Core>

namespace sbox {

/// x and y in metres, phi in radians, counter-clockwise.
using Pose2D = mrpt::math::TPose2D;
/// A point of the plane, in metres.
using Point2D = mrpt::math::TPoint2D;
/// Covariance of (x, y, phi), in m^2, m rad and rad^2.
using PoseCovariance = Eigen::Matrix3d;

/// pose_a_in_b from pose_b_in_a; phi in (-pi, pi].
[[nodiscard]] Pose2D inverse(const Pose2D& pose_b_in_a);

/// The angle folded into (-pi, pi], in radians.
[[nodiscard]] double wrapAngle(double angle);

/// Covariance of the inverse transform: from that of pose_b_in_a (additive on x, y and phi) to that
/// of pose_a_in_b, to first order.
[[nodiscard]] PoseCovariance inverseCovariance(const Pose2D& pose_b_in_a,
                                               const PoseCovariance& covariance);

}  // namespace sbox
