// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sbox/core/pose.h"

namespace sbox {

/// Two key frames, by their numbers; a < b.
struct FramePair {
  int a = 0;  ///< Index of the earlier key frame.
  int b = 0;  ///< Index of the later key frame.
};

/// Which key frames may have seen the same.
struct OverlapOptions {
  double radius = 3;     ///< Between the robots, in metres.
  double turn_cost = 1;  ///< A heading off by a radian counts as this many metres.
  int partners = 6;      ///< Looked for at most for each key frame, in passages of their own.
  int passage = 4;       ///< Key frames this near in the drive are one passage.
};

/// Pairs of key frames that stand near each other but not one after the other: the nearest of each
/// passage of a robot. `map_of` holds the number of the map of each, and its frames follow one
/// another. Sorted, each pair once.
[[nodiscard]] std::vector<FramePair> overlappingFrames(const std::vector<Pose2D>& poses,
                                                       const std::vector<int>& map_of,
                                                       const OverlapOptions& options = {});

}  // namespace sbox
