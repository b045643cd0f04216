// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Coarse-to-fine verification: many hypotheses are asked of few wall points, the better ones of
// more; those left are aligned and asked of all.
#pragma once

#include <vector>

#include "sbox/alignment/drift_field.h"
#include "sbox/alignment/evidence.h"
#include "sbox/alignment/wall_alignment.h"
#include "sbox/features/map_features.h"
#include "sbox/matching/hypothesis.h"
#include "sbox/verification/fit.h"

namespace sbox {

/// How many transforms each step keeps.
struct RankingOptions {
  int first_points = 32;       ///< Wall points of each map that every hypothesis is asked of.
  int first_kept = 400;        ///< Hypotheses kept after that.
  int coarse_points = 100;     ///< Wall points that these are asked of.
  int coarse_kept = 60;        ///< Hypotheses kept after that.
  int fine_points = 500;       ///< Wall points that these are asked of.
  int aligned = 20;            ///< Distinct hypotheses that are aligned.
  double aligned_within = 16;  ///< Those further from the most plausible go no further, log odds.
  int kept = 12;               ///< Distinct fits that are looked at with the drift taken out ...
  double kept_within = 12;     ///< ... if they are this near to the most plausible, log odds.
  int bent_points = 2000;      ///< Wall points that these are asked of.
  double same_distance = 1.0;  ///< Nearer answers are one, metres.
  double same_turn = 7.0;      ///< Nearer answers are one, degrees.
  double same_bent = 0.6;      ///< Fits that lay the walls this near once bent are one, metres.
  EvidenceOptions evidence;    ///< Of rigid transforms.
  EvidenceOptions bent_evidence = {0.25, 0.15, 0.45};  ///< With the drift taken out.
  AlignmentOptions first_alignment = {1.25, 6, 500};   ///< Of the best ones, coarsely ...
  AlignmentOptions alignment;                          ///< ... and of those that are kept.
  DriftOptions drift;                                  ///< Of maps that are bent.
};

/// The best distinct fits, with their log odds, in no order that means anything. If thorough, a
/// second, more careful alignment is tried, too, where walls are dense. The order of the hypotheses
/// matters only between equals, and the number of threads (0: one a core) only for the time.
[[nodiscard]] std::vector<Fit> rankHypotheses(const MapFeatures& a, const MapFeatures& b,
                                              const std::vector<Hypothesis>& hypotheses,
                                              const RankingOptions& options = {},
                                              bool is_thorough = false, int threads = 1);

}  // namespace sbox
