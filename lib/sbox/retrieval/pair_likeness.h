// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How alike two maps look, at a small part of the cost of matching them: the transforms with most
// votes of corners and boxes, asked of a few wall points.
#pragma once

#include "sbox/alignment/evidence.h"
#include "sbox/features/map_features.h"
#include "sbox/matching/feature_votes.h"

namespace sbox {

/// How closely is looked.
struct LikenessOptions {
  int max_hypotheses = 100;  ///< Transforms with most votes.
  int min_per_heading = 5;   ///< Kept of each pair of frames and quarter turn.
  int first_points = 32;     ///< Wall points of each map that all are asked of.
  int kept = 10;             ///< Transforms kept after that.
  int points = 200;          ///< Wall points that these are asked of.
};

/// Plausibility of the best transform: higher is more alike, kImplausible where none lays the maps
/// on each other. Infinite where a map has no corner to look by, so that nothing is known. The
/// order of the maps does not matter. `votes`, but for what `options` says itself, and `evidence`
/// say what is alike.
[[nodiscard]] double pairLikeness(const MapFeatures& a, const MapFeatures& b,
                                  const LikenessOptions& options = {},
                                  const VoteOptions& votes = {},
                                  const EvidenceOptions& evidence = {});

}  // namespace sbox
