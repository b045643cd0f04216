// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Refinement (section 3.3): the transform that is reported, with its covariance, beside the answers
// of the Kalman step and of Ceres.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "sbox/alignment/drift_field.h"
#include "sbox/features/map_features.h"
#include "sbox/matching/matched_boxes.h"
#include "sbox/refinement/box_kalman.h"
#include "sbox/refinement/ceres_polish.h"
#include "sbox/refinement/pose_covariance.h"

namespace sbox {

/// Options of the refinement.
struct RefineOptions {
  /// Roughness of the drift field (metres) below which maps count as free of drift, so that Ceres's
  /// narrow kernel is right for them; in bent maps it would lock on to one part of the building.
  double drift_free = 0.1;
  /// Farther than this from the rigid transform nearest to the bent fit, metres, Ceres has left the
  /// walls that the fit lies on for others beside them.
  double most_polish = 0.3;
  BoxKalmanOptions kalman;       ///< Of the Kalman step.
  PolishOptions polish;          ///< Of Ceres.
  CovarianceOptions covariance;  ///< Of what is reported.
  /// Distance of Kalman and Ceres beyond which something is amiss, metres; of bent maps, which no
  /// one transform fits, as many times as large as they are rougher than `drift_free`, or
  /// than a millimetre, ...
  double large_difference = 0.5;
  double difference_odds = 0.2;  ///< ... so the odds of being right are multiplied by this.
};

/// The answer of the refinement.
struct RefinedPose {
  RigidTransform b_in_a;       ///< What is reported.
  Eigen::Vector2d pivot_b;     ///< The middle of map b, in its grid frame, metres.
  Eigen::Matrix3d covariance;  ///< Of (x, y, heading) of the pivot in map a; m^2, m rad, rad^2.
  std::optional<RigidTransform> kalman;  ///< None without agreeing corners.
  std::optional<RigidTransform> ceres;   ///< None without agreeing walls.
  /// Whether Kalman and Ceres differ by more than the bend explains; see `large_difference`.
  bool is_doubtful = false;

  /// How far apart Kalman and Ceres put the pivot, metres; 0 where one gave no answer.
  [[nodiscard]] double disagreement() const;
};

/// Refines the transform that verification found. Reported is the answer of Ceres where the maps
/// are free of drift and it stays with the walls, else the rigid transform nearest to the bent fit.
[[nodiscard]] RefinedPose refinePose(const MapFeatures& a, const MapFeatures& b,
                                     const RigidTransform& found, const DriftField& drift,
                                     const std::vector<BoxMatch>& boxes,
                                     const RefineOptions& options = {});

}  // namespace sbox
