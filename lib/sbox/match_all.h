// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Features once a map, then all pairs, side by side on several threads, whichever method does them.
#pragma once

#include <vector>

#include "sbox/core/feature_set.h"
#include "sbox/core/map.h"
#include "sbox/core/parallel.h"
#include "sbox/placement/map_pair.h"
#include "sbox/progress.h"
#include "sbox/stopwatch.h"

namespace sbox {

/// What matching all pairs gives.
struct MatchedMaps {
  std::vector<FeatureSet> features;  ///< Of each map.
  std::vector<MapPair> pairs;        ///< All, ordered by a, then b.
  double feature_seconds = 0;        ///< Wall time of the features of all maps.
};

/// `extract(map)` gives features that have a `feature_set`; `match(features_a, features_b)` gives a
/// PairResult. Both are called from several threads at once.
template <typename Extract, typename Match>
MatchedMaps matchAll(const std::vector<Map>& maps, const Extract& extract, const Match& match,
                     int threads, const ProgressFunction& tell) {
  MatchedMaps matched;
  const auto count = static_cast<int>(maps.size());
  std::vector<decltype(extract(maps[0]))> features(maps.size());
  const Stopwatch stopwatch;
  StageProgress features_progress(tell, "features", count);
  parallelFor(count, threads, [&](int i) {
    features_progress.partBegins();
    features[static_cast<size_t>(i)] = extract(maps[static_cast<size_t>(i)]);
    features_progress.partDone();
  });
  matched.feature_seconds = stopwatch.seconds();

  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      matched.pairs.push_back({a, b, {}});
    }
  }
  const auto pair_count = static_cast<int>(matched.pairs.size());
  StageProgress pairs_progress(tell, "pairs", pair_count);
  parallelFor(pair_count, threads, [&](int i) {
    pairs_progress.partBegins();
    MapPair& pair = matched.pairs[static_cast<size_t>(i)];
    pair.result =
        match(features[static_cast<size_t>(pair.a)], features[static_cast<size_t>(pair.b)]);
    pairs_progress.partDone();
  });
  for (auto& of_map : features) {
    matched.features.push_back(std::move(of_map.feature_set));
  }
  return matched;
}

}  // namespace sbox
