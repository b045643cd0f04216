// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/match_maps.h"

#include "sbox/method_features.h"

namespace sbox {

MatchedPair matchMaps(const Map& a, const Map& b, const MergeOptions& options) {
  const MethodFeatures of_a = extractMethodFeatures(a, options);
  const MethodFeatures of_b = extractMethodFeatures(b, options);
  return {matchMethodFeatures(of_a, of_b, options, {}, options.threads), featureSetOf(of_a),
          featureSetOf(of_b)};
}

}  // namespace sbox
