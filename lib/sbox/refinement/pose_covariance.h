// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far a transform can be trusted. The inverse Hessian of the alignment takes every stretch of
// wall for a new observation, which holds in maps without drift only; drift moves whole rooms. So
// the covariance is that of walls that err together over some metres, and a term that grows with
// the drift seen and shrinks with the wall that agrees.
#pragma once

#include <Eigen/Core>

namespace sbox {

/// Constants of the model, by maximum likelihood over map pairs with known truth, every family of
/// data with the same weight (README: table of normalised errors).
struct CovarianceOptions {
  double wall_noise = 0.02;         ///< Standard deviation of a wall's offset, metres.
  double correlation_length = 5.0;  ///< Length of wall that errs together, metres.
  /// Standard deviation of the shift by drift, metres: this times the squared roughness of the
  /// drift field (metres) times (50 m / agreeing wall)^1.5.
  double drift_shift = 45;
  /// Standard deviation of the turn by drift, radians, times the spread of the walls about their
  /// middle (metres): this times roughness^1.5 times 50 m / agreeing wall.
  double drift_turn = 5;
};

/// Covariance of (x, y, heading) of a pivot: square metres, metre radians, square radians.
/// `information`: of wallInformation() about the pivot; `roughness`: of the drift field, metres.
/// Positive definite; large along what no wall fixes.
[[nodiscard]] Eigen::Matrix3d poseCovariance(const Eigen::Matrix3d& information, double roughness,
                                             const CovarianceOptions& options = {});

}  // namespace sbox
