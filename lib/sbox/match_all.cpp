// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/match_all.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "sbox/core/parallel.h"

namespace sbox {
namespace {

const MapFeatures* boxFeatures(const MatchStore& store, int map) {
  return std::get_if<MapFeatures>(&*store.features[static_cast<size_t>(map)]);
}

/// How alike the maps of the share and all maps look, by pair in ascending order.
std::vector<PairLikeness> compareAll(const MergeOptions& options, MatchStore& store,
                                     const ProgressFunction& tell, const PairShare& share) {
  std::vector<PairLikeness> compared;
  for (const PairIndex& pair : allPairs(static_cast<int>(store.features.size()))) {
    if (share.holds(pair.first) || share.holds(pair.second)) {
      compared.push_back({pair, 0});
    }
  }
  std::vector<PairLikeness*> missing;
  for (PairLikeness& pair : compared) {
    const auto found = store.likeness.find(pair.maps);
    if (found != store.likeness.end()) {
      pair.likeness = found->second;
    } else {
      missing.push_back(&pair);
    }
  }
  const auto count = static_cast<int>(missing.size());
  StageProgress progress(tell, "maps compared", count);
  parallelFor(count, options.threads, [&](int i) {
    progress.partBegins();
    PairLikeness& pair = *missing[static_cast<size_t>(i)];
    pair.likeness =
        pairLikeness(*boxFeatures(store, pair.maps.first), *boxFeatures(store, pair.maps.second),
                     options.retrieval.likeness, options.pair.votes, options.pair.ranking.evidence);
    progress.partDone();
  });
  for (const PairLikeness* pair : missing) {
    store.likeness.emplace(pair->maps, pair->likeness);
  }
  return compared;
}

/// Where initial guesses put two maps, if both have one.
std::optional<GuessedPoses> guessOf(const std::vector<const InitialGuess*>& guesses, int map_a,
                                    int map_b) {
  const InitialGuess* a = guesses[static_cast<size_t>(map_a)];
  const InitialGuess* b = guesses[static_cast<size_t>(map_b)];
  if (a == nullptr || b == nullptr) {
    return std::nullopt;
  }
  return GuessedPoses{a->pose, b->pose, std::hypot(a->sigma_xy, b->sigma_xy), a->sigma_phi,
                      b->sigma_phi};
}

/// Every so many of the pairs.
std::vector<PairIndex> shareOf(const std::vector<PairIndex>& pairs, const PairShare& share) {
  std::vector<PairIndex> held;
  for (size_t i = 0; i < pairs.size(); ++i) {
    if (share.holds(static_cast<int>(i))) {
      held.push_back(pairs[i]);
    }
  }
  return held;
}

}  // namespace

void extractAll(const std::vector<Map>& maps, const MergeOptions& options, MatchStore& store,
                const ProgressFunction& tell) {
  store.features.resize(maps.size());
  std::vector<size_t> missing;
  for (size_t i = 0; i < maps.size(); ++i) {
    if (!store.features[i]) {
      missing.push_back(i);
    }
  }
  const auto count = static_cast<int>(missing.size());
  StageProgress progress(tell, "features", count);
  parallelFor(count, options.threads, [&](int i) {
    progress.partBegins();
    const size_t map = missing[static_cast<size_t>(i)];
    store.features[map] = extractMethodFeatures(maps[map], options);
    progress.partDone();
  });
}

std::vector<PairIndex> pairsToMatch(const std::vector<Footprint>& footprints,
                                    const MergeOptions& options, MatchStore& store,
                                    const ProgressFunction& tell, const PairShare& share) {
  if (store.pairs) {
    return *store.pairs;
  }
  const auto count = static_cast<int>(footprints.size());
  const int partners = options.retrieval.partners;
  if (options.method != Method::Boxes || partners == 0 || count <= partners + 1) {
    return shareOf(allPairs(count), share);
  }
  const std::vector<PairIndex> alike =
      choosePairs(count, compareAll(options, store, tell, share), partners, share);
  const std::vector<PairIndex> guessed =
      shareOf(pairsThatMayMeet(options.initial, footprints), share);
  std::vector<PairIndex> pairs;
  std::set_union(alike.begin(), alike.end(), guessed.begin(), guessed.end(),
                 std::back_inserter(pairs));
  return pairs;
}

std::vector<PairIndex> matchPairs(const std::vector<PairIndex>& pairs, const MergeOptions& options,
                                  MatchStore& store, const ProgressFunction& tell) {
  std::vector<PairIndex> missing;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(missing),
               [&](const PairIndex& pair) { return store.results.count(pair) == 0; });
  const auto count = static_cast<int>(missing.size());
  std::vector<PairResult> results(missing.size());
  const std::vector<const InitialGuess*> guesses =
      guessOfEachMap(options.initial, store.features.size());
  StageProgress progress(tell, "pairs", count);
  // Where there are fewer pairs than threads, as with two maps, several work on each.
  const int threads = threadCount(options.threads);
  const int threads_a_pair = std::max(1, threads / std::max(1, count));
  parallelFor(count, threads, [&](int i) {
    progress.partBegins();
    const auto [a, b] = missing[static_cast<size_t>(i)];
    results[static_cast<size_t>(i)] = matchMethodFeatures(
        *store.features[static_cast<size_t>(a)], *store.features[static_cast<size_t>(b)], options,
        guessOf(guesses, a, b), threads_a_pair);
    progress.partDone();
  });
  for (size_t i = 0; i < missing.size(); ++i) {
    store.results.emplace(missing[i], std::move(results[i]));
  }
  return missing;
}

std::vector<MapPair> matchedPairs(const std::vector<PairIndex>& pairs, const MatchStore& store) {
  std::vector<MapPair> matched;
  for (const PairIndex& pair : pairs) {
    matched.push_back({pair.first, pair.second, store.results.at(pair)});
  }
  return matched;
}

}  // namespace sbox
