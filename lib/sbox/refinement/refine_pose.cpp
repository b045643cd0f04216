// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/refine_pose.h"

#include "sbox/refinement/corner_pairs.h"
#include "sbox/refinement/mean_transform.h"
#include "sbox/refinement/wall_alignment.h"

namespace sbox {

double RefinedPose::disagreement() const {
  return kalman && ceres ? (*kalman * pivot_b - *ceres * pivot_b).norm() : 0;
}

RefinedPose refinePose(const MapFeatures& a, const MapFeatures& b, const RigidTransform& found,
                       const DriftField& drift, const std::vector<BoxMatch>& boxes,
                       const RefineOptions& options) {
  RefinedPose refined;
  refined.pivot_b = Eigen::Vector2d(b.width / 2, b.height / 2);
  // Eqs. 6 to 14 on the transform itself, and its cross-check.
  const std::vector<CornerPair> corners = uniqueCorners(boxes, options.kalman.corner_noise);
  if (const auto filtered = filterCorners(corners, found, refined.pivot_b, options.kalman)) {
    refined.kalman = filtered->b_in_a;
  }
  refined.ceres = polishByCeres(a, b, corners, found, refined.pivot_b, options.polish);
  refined.b_in_a = refined.ceres && drift.roughness() < options.drift_free
                       ? *refined.ceres
                       : meanTransform(a, b, found, drift);
  refined.covariance =
      poseCovariance(wallInformation(a, b, refined.b_in_a), drift.roughness(), options.covariance);
  return refined;
}

}  // namespace sbox
