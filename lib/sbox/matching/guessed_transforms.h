// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where somebody thinks that two maps lie narrows the search: the transforms round there.
#pragma once

#include <vector>

#include "sbox/features/map_features.h"
#include "sbox/matching/heading_candidates.h"
#include "sbox/matching/hypothesis.h"

namespace sbox {

/// Rough poses of two maps in some common frame.
struct GuessedPoses {
  Pose2D pose_a;           ///< Frame of map a.
  Pose2D pose_b;           ///< Frame of map b.
  double sigma_xy = 1;     ///< Standard deviation of b's frame in a's along each axis, metres.
  double sigma_phi_a = 1;  ///< Standard deviation of the heading of a, radians.
  double sigma_phi_b = 1;  ///< Standard deviation of the heading of b, radians.
};

/// Which transforms count as near a guess.
struct GuessOptions {
  double deviations = 2.5;  ///< Standard deviations from the guess.
  double spacing = 0.8;     ///< Between neighbouring translations, metres ...
  int most = 2000;          ///< ... or more, so that a heading has no more than this many.
};

/// Transforms on a lattice round the guess, at the headings where the walls of both maps face the
/// same ways; at the guess's own heading if there are none near it.
[[nodiscard]] std::vector<Hypothesis> transformsNear(const MapFeatures& a, const MapFeatures& b,
                                                     const GuessedPoses& guess,
                                                     const HeadingOptions& headings,
                                                     const GuessOptions& options = {});

/// Those of the hypotheses that the guess allows, in their order.
[[nodiscard]] std::vector<Hypothesis> allowedBy(const GuessedPoses& guess, const MapFeatures& a,
                                                const MapFeatures& b,
                                                const std::vector<Hypothesis>& hypotheses,
                                                const GuessOptions& options = {});

}  // namespace sbox
