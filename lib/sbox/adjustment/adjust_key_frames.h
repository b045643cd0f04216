// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps that have drifted do not fit each other everywhere by any rigid transform. Here the key
// frames of all robots move together: those one after the other by their SLAM, those that stand
// near each other by what they saw, in one pose graph whose robust loss leaves out what
// contradicts.
#pragma once

#include <vector>

#include "sbox/adjustment/match_scans.h"
#include "sbox/adjustment/overlapping_frames.h"
#include "sbox/adjustment/scan_points.h"
#include "sbox/core/key_frame.h"
#include "sbox/core/progress.h"
#include "sbox/fusion/join_key_frames.h"

namespace sbox {

/// How key frames are adjusted.
struct AdjustmentOptions {
  ScanPointOptions points;    ///< What is laid on each other.
  OverlapOptions overlap;     ///< What is tried.
  ScanMatchOptions match;     ///< What counts as seen twice.
  int rounds = 3;             ///< Key frames are matched anew from where they were moved to.
  double step_metres = 0.03;  ///< Standard deviation from one key frame to the next, metres, ...
  double step_share = 0.03;   ///< ... and what a metre between them adds.
  double step_turn = 0.02;    ///< Standard deviation from one key frame to the next, radians.
  double loss_scale = 2;      ///< Of Cauchy's loss, in standard deviations of an edge.
};

/// The key frames of all maps, map by map, in the frame of the reference, as joinKeyFrames gives
/// them, but adjusted. The frame stays: the reference map's key frames do not move on average,
/// nor do those of maps that no scan ties to it.
/// Two to six seconds for 1000 key frames on one core, by the points of a scan. Throws
/// std::invalid_argument if a map's are missing. 0 threads: one a core; the same result with any
/// number.
[[nodiscard]] KeyFrames adjustKeyFrames(const std::vector<PlacedKeyFrames>& maps, size_t reference,
                                        const AdjustmentOptions& options = {}, int threads = 0,
                                        const ProgressFunction& progress = {});

}  // namespace sbox
