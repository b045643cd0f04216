// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/refine_pose.h"

#include <Eigen/Cholesky>

#include "sbox/refinement/corner_pairs.h"

namespace sbox {
namespace {

/// Walls of one stretch err together, so a stretch counts as one observation. What nothing fixes
/// keeps the variance of not knowing.
Eigen::Matrix3d poseCovariance(const Eigen::Matrix3d& information, const DriftField& drift,
                               const RefineOptions& options) {
  const double roughness = options.drift_share * drift.roughness();
  const double variance = options.wall_noise * options.wall_noise + roughness * roughness;
  Eigen::Matrix3d weight = information / (options.correlation_length * variance);
  constexpr double unknown_shift = 30, unknown_turn = 1;  // Metres and radians.
  weight.diagonal() +=
      Eigen::Vector3d(1 / (unknown_shift * unknown_shift), 1 / (unknown_shift * unknown_shift),
                      1 / (unknown_turn * unknown_turn));
  Eigen::Matrix3d covariance = weight.ldlt().solve(Eigen::Matrix3d::Identity());
  const double shift = options.common_drift * drift.roughness(), turn = shift / drift.spacing;
  covariance.diagonal() += Eigen::Vector3d(shift * shift, shift * shift, turn * turn);
  return covariance;
}

}  // namespace

RefinedPose refinePose(const MapFeatures& a, const MapFeatures& b, const RigidTransform& found,
                       const DriftField& drift, const std::vector<BoxMatch>& boxes,
                       const RefineOptions& options) {
  RefinedPose refined;
  refined.pivot_b = Eigen::Vector2d(b.width / 2, b.height / 2);
  refined.b_in_a =
      drift.roughness() < options.drift_free ? alignWalls(a, b, found, options.tight) : found;
  refined.covariance = poseCovariance(wallInformation(a, b, refined.b_in_a), drift, options);
  // Eqs. 6 to 14 on the transform itself, and its cross-check.
  const std::vector<CornerPair> corners = uniqueCorners(boxes, options.kalman.corner_noise);
  if (const auto filtered = filterCorners(corners, found, refined.pivot_b, options.kalman)) {
    refined.kalman = filtered->b_in_a;
  }
  refined.ceres = polishByCeres(a, b, corners, found, refined.pivot_b, options.polish);
  return refined;
}

}  // namespace sbox
