// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/refine_pose.h"

#include <algorithm>

#include "sbox/alignment/wall_alignment.h"
#include "sbox/refinement/corner_pairs.h"
#include "sbox/refinement/mean_transform.h"

namespace sbox {
namespace {

/// How far apart two transforms put a wall of map b that lies on map a, at most, metres.
double largestShift(const MapFeatures& a, const MapFeatures& b, const RigidTransform& left,
                    const RigidTransform& right) {
  double largest = 0;
  for (const WallPoint& point : b.wall_points) {
    const Eigen::Vector2d in_a = left * point.position;
    if (a.fields.cellAt(in_a.x(), in_a.y()) >= 0) {
      largest = std::max(largest, (in_a - right * point.position).norm());
    }
  }
  return largest;
}

}  // namespace

double RefinedPose::disagreement() const {
  return kalman && ceres ? (*kalman * pivot_b - *ceres * pivot_b).norm() : 0;
}

RefinedPose refinePose(const MapFeatures& a, const MapFeatures& b, const RigidTransform& found,
                       const DriftField& drift, const std::vector<BoxMatch>& boxes,
                       const RefineOptions& options) {
  RefinedPose refined;
  refined.pivot_b = b.middle();
  // Eqs. 6 to 14 on the transform itself, to check what is reported.
  const std::vector<CornerPair> corners = uniqueCorners(boxes, options.kalman.corner_noise);
  if (const auto filtered = filterCorners(corners, found, refined.pivot_b, options.kalman)) {
    refined.kalman = filtered->b_in_a;
  }
  refined.ceres = polishByCeres(a, b, corners, found, refined.pivot_b, options.polish);
  refined.b_in_a = meanTransform(a, b, found, drift);
  if (refined.ceres && drift.roughness() < options.drift_free &&
      largestShift(a, b, refined.b_in_a, *refined.ceres) < options.most_polish) {
    refined.b_in_a = *refined.ceres;
  }
  constexpr double least_drift = 1e-3;  // Metres.
  const double drift_free = std::max(options.drift_free, least_drift);
  refined.is_doubtful = refined.disagreement() >
                        options.large_difference * std::max(1.0, drift.roughness() / drift_free);
  refined.covariance =
      poseCovariance(wallInformation(a, b, refined.b_in_a), drift.roughness(), options.covariance);
  return refined;
}

}  // namespace sbox
