// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What counts as a right answer. The rule is fixed, so that figures of different tools compare.
#pragma once

#include <optional>

#include "sbox-bench/annotated_pairs.h"
#include "sbox/core/pose.h"

namespace sbox::bench {

enum class Outcome {
  Right,   ///< Accepted and near the annotated points; or refused where nothing is in common.
  Wrong,   ///< Accepted and not right.
  Refused  ///< Not accepted although the maps belong together.
};

/// "right", "wrong" or "refused".
[[nodiscard]] const char* toString(Outcome outcome);

/// How far a transform is from the truth.
struct PoseError {
  double excess_cells = 0;  ///< RMS distance of the annotated points less the floor.
  double rotation_deg = 0;  ///< From the nearest rotation that counts as right, >= 0.
  bool right = false;       ///< Within the pair's tolerance and 5 degrees.
};

/// The error of a transform, from the corner of a's grid to the corner of b's in metres; none for
/// pairs that have nothing in common.
[[nodiscard]] std::optional<PoseError> poseError(const AnnotatedPair& pair, double resolution,
                                                 const Pose2D& corner_a_in_corner_b);

/// The outcome of an answer that was accepted or not. An accepted answer to a pair with nothing in
/// common is wrong.
[[nodiscard]] Outcome judge(const AnnotatedPair& pair, bool accepted,
                            const std::optional<PoseError>& error);

/// The transform between the corners of two grids, for a pose between the maps' frames.
[[nodiscard]] Pose2D cornerTransform(const Pose2D& pose_b_in_a, const Pose2D& corner_in_a,
                                     const Pose2D& corner_in_b);

/// The pose between the maps' frames, for a transform between the corners of their grids: the
/// inverse of cornerTransform.
[[nodiscard]] Pose2D poseFromCorners(const Pose2D& corner_a_in_corner_b, const Pose2D& corner_in_a,
                                     const Pose2D& corner_in_b);

}  // namespace sbox::bench
