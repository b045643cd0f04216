// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox-bench/annotated_pairs.h"

namespace sbox::bench {

/// What the annotated points say of the pose of b in a, and how surely.
struct AnnotatedTruth {
  Pose2D pose_b_in_a;   ///< The annotated rigid fit, between the maps' frames.
  Point2D centre_in_b;  ///< The middle of the annotated points in map b, metres.
  /// The fit's own standard errors as a covariance of (x, y, phi) about that middle, as any least
  /// squares has them: few points that fit badly fix a pose badly. Zero where all fit exactly.
  PoseCovariance covariance = PoseCovariance::Zero();
};

/// The truth of a pair with at least two points. The corners are those of the maps' grids.
[[nodiscard]] AnnotatedTruth annotatedTruth(const AnnotatedPair& pair, double resolution,
                                            const Pose2D& corner_in_a, const Pose2D& corner_in_b);

}  // namespace sbox::bench
