// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Iterative closest points between what two key frames saw, each point against the line of the
// nearest surface that faces the same way.
#pragma once

#include <optional>
#include <vector>

#include "sbox/adjustment/scan_points.h"
#include "sbox/core/pose.h"

namespace sbox {

/// How the points of two key frames are laid on each other.
struct ScanMatchOptions {
  double gate = 0.5;        ///< Points farther apart do not match in the first rounds, metres; ...
  double last_gate = 0.15;  ///< ... it shrinks to this in the last.
  double most_turn = 0.5;   ///< Surfaces that face more different ways do not match, radians.
  double kernel = 0.05;     ///< Scale of the robust kernel, metres.
  int iterations = 10;      ///< All are done.
  double noise = 0.1;       ///< Standard deviation of a point that counts as independent, metres.
  double least_overlap = 0.4;  ///< Share of the points, of the frame with fewer, that must match.
  double most_shift = 0.5;     ///< Between start and answer, metres: farther is no answer.
  double most_rotation = 0.1;  ///< Between start and answer, radians: more is no answer.
};

/// Where one key frame lies as seen from another.
struct ScanMatch {
  Pose2D pose_b_in_a;         ///< Robot at b in the frame of the robot at a.
  PoseCovariance covariance;  ///< Wide along what the surfaces do not fix, as down a corridor.
  double overlap = 0;         ///< Share of the points, of the frame with fewer, that match.
};

/// Lays b on a from `start`; none where too little fits or it leads too far away.
[[nodiscard]] std::optional<ScanMatch> matchScans(const std::vector<ScanPoint>& a,
                                                  const std::vector<ScanPoint>& b,
                                                  const Pose2D& start,
                                                  const ScanMatchOptions& options = {});

}  // namespace sbox
