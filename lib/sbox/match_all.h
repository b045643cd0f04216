// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Features once a map, then the pairs that are worth it, side by side on several threads.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "sbox/core/map.h"
#include "sbox/core/progress.h"
#include "sbox/method_features.h"
#include "sbox/placement/footprint.h"
#include "sbox/placement/map_pair.h"

namespace sbox {

/// What is known of a set of maps before they are placed. Each step fills in what is missing, so
/// that what stays the same is not done again.
struct MatchStore {
  std::optional<std::vector<PairIndex>> pairs;          ///< Worth matching, if known beforehand.
  std::vector<std::optional<MethodFeatures>> features;  ///< Of each map.
  std::map<PairIndex, double> likeness;                 ///< Of pairs that were compared.
  std::map<PairIndex, PairResult> results;              ///< Of pairs that were matched.
};

/// Features of all maps that have none.
void extractAll(const std::vector<Map>& maps, const MergeOptions& options, MatchStore& store,
                const ProgressFunction& tell = {});

/// The pairs of the share that are worth matching: all of few maps, and all by the published
/// method; else those that choosePairs() takes by the maps' likeness, and those that initial
/// guesses lay on each other. In ascending order. Needs the features of all maps.
[[nodiscard]] std::vector<PairIndex> pairsToMatch(const std::vector<Footprint>& footprints,
                                                  const MergeOptions& options, MatchStore& store,
                                                  const ProgressFunction& tell = {},
                                                  const PairShare& share = {});

/// Matches those of the pairs that have no result, and names them. Needs the features of their
/// maps.
std::vector<PairIndex> matchPairs(const std::vector<PairIndex>& pairs, const MergeOptions& options,
                                  MatchStore& store, const ProgressFunction& tell = {});

/// The pairs with their results, which the store must have.
[[nodiscard]] std::vector<MapPair> matchedPairs(const std::vector<PairIndex>& pairs,
                                                const MatchStore& store);

}  // namespace sbox
