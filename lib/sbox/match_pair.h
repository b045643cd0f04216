// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The default method for two maps: corners and boxes propose transforms, the cells decide.
#pragma once

#include <optional>
#include <vector>

#include "sbox/core/pair_result.h"
#include "sbox/features/map_features.h"
#include "sbox/matching/correlation_search.h"
#include "sbox/matching/feature_votes.h"
#include "sbox/matching/guessed_transforms.h"
#include "sbox/matching/matched_boxes.h"
#include "sbox/refinement/refine_pose.h"
#include "sbox/verification/rank_hypotheses.h"
#include "sbox/verification/same_answer.h"
#include "sbox/verification/verdict.h"
#include "sbox/verification/verdict_model.h"

namespace sbox {

/// Options of every stage of a pair, and of the features it needs.
struct PairOptions {
  FeatureOptions features;               ///< Of extractFeatures.
  VoteOptions votes;                     ///< Transforms that features propose.
  GuessOptions guess;                    ///< Where to look first if somebody knows roughly.
  CorrelationSearchOptions correlation;  ///< The search where features propose nothing sure.
  double sure = 0.999;  ///< Probability from which the search ends with what the features proposed.
  RankingOptions ranking;  ///< Which transforms fit the cells.
  SameAnswerOptions same;  ///< Which fits are one answer.
  VerdictOptions verdict;  ///< When to accept.
  BoxMatchOptions boxes;   ///< Boxes that count as agreeing.
  RefineOptions refine;    ///< Kalman, Ceres and the pose that is reported.
};

/// Where one map may lie in the other, a fit for each answer, judged, the most probable first: near
/// the guess, if there is one, then by what features propose, then by a full search, which is left
/// out where there is no doubt.
[[nodiscard]] std::vector<Fit> findAnswers(const MapFeatures& a, const MapFeatures& b,
                                           const PairOptions& options, PairSeconds& seconds,
                                           const std::optional<GuessedPoses>& guess = {},
                                           int threads = 1);

/// The pose of the map frame of b in that of a, for a transform between the grid frames.
[[nodiscard]] Pose2D framePose(const MapFeatures& a, const MapFeatures& b,
                               const RigidTransform& b_in_a);

/// Matches two maps by their features. What can't be matched is refused; exchanging the maps gives
/// the inverse, exactly. A guess tells where to look first, not what to accept; the number of
/// threads (0: one a core) changes nothing but the time.
[[nodiscard]] PairResult matchPair(const MapFeatures& a, const MapFeatures& b,
                                   const PairOptions& options = {},
                                   const std::optional<GuessedPoses>& guess = {}, int threads = 1);

}  // namespace sbox
