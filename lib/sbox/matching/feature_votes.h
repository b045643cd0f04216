// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corners and boxes of two maps that look alike vote for the transform that lays one on the other
// (section 3.2: rough match and eq. 4; the filter is done by counting).
#pragma once

#include <vector>

#include "sbox/features/map_features.h"
#include "sbox/matching/hypothesis.h"

namespace sbox {

/// How features vote.
struct VoteOptions {
  double bin = 0.6;             ///< Edge of a bin of translations, metres; more where maps are ...
  double most_bins = 4e6;       ///< ... so large that there would be more bins.
  double box_weight = 1.0;      ///< Of a pair of boxes; a pair of corners counts 1.
  double size_tolerance = 0.4;  ///< Between the sides of two boxes, metres; and ...
  double size_ratio = 0.06;     ///< ... as a share of the side: long sides drift more.
  int max_hypotheses = 1000;    ///< The bins with most votes.
  int min_per_heading = 50;     ///< Kept of each pair of frames and quarter turn.
};

/// For each pair of frames and each of the four quarter turns, the translations with most votes;
/// the most votes first.
[[nodiscard]] std::vector<Hypothesis> voteForTransforms(const MapFeatures& a, const MapFeatures& b,
                                                        const VoteOptions& options = {});

}  // namespace sbox
