// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The Kalman step (section 3.3, eqs. 6 to 14) on the transform itself instead of cell by cell: the
// state is where the centre of map b lies in map a, and the heading; each corner of an agreeing box
// is an observation. The paper's own form is in paper/kalman_step.h.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "sbox/core/rigid_transform.h"
#include "sbox/refinement/corner_pairs.h"

namespace sbox {

/// Options of the Kalman step.
struct BoxKalmanOptions {
  double corner_noise = 1.0;      ///< Least standard deviation of a corner, metres.
  double prediction_shift = 0.3;  ///< Standard deviation of the predicted place, metres.
  double prediction_turn = 1.0;   ///< Standard deviation of the predicted heading, degrees.
  double gate = 9.21;  ///< Squared Mahalanobis distance beyond which a corner is left out; 99 % of
                       ///< chi-squared with 2 degrees of freedom.
};

/// The state after all corners.
struct BoxKalmanResult {
  RigidTransform b_in_a;  ///< Grid frame of map b in that of map a.
  /// Of (x, y, heading) about the pivot. Takes corners for independent, which drift does not let
  /// them be: too small where maps are bent; see pose_covariance.h for what to rely on.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  int used = 0;  ///< Corners that passed the gate.
};

/// The transform after all corners, starting from `prediction` (eq. 6); none if no corner passes
/// the gate. `pivot_b`: the point of map b, in its grid frame, about which the state is taken.
[[nodiscard]] std::optional<BoxKalmanResult> filterCorners(const std::vector<CornerPair>& corners,
                                                           const RigidTransform& prediction,
                                                           const Eigen::Vector2d& pivot_b,
                                                           const BoxKalmanOptions& options = {});

}  // namespace sbox
