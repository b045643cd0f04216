// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two maps by the method chosen, without placement and fusion.
#pragma once

#include "sbox/core/feature_set.h"
#include "sbox/core/map.h"
#include "sbox/core/pair_result.h"
#include "sbox/merge_options.h"

namespace sbox {

/// What is known of two maps.
struct MatchedPair {
  PairResult result;      ///< Verdict and transform.
  FeatureSet features_a;  ///< Of map a, in its frame.
  FeatureSet features_b;  ///< Of map b, in its frame.
};

/// Matches maps a and b as mergeMaps does.
[[nodiscard]] MatchedPair matchMaps(const Map& a, const Map& b, const MergeOptions& options = {});

}  // namespace sbox
