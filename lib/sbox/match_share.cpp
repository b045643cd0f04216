// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/match_share.h"

#include <algorithm>
#include <set>
#include <utility>

#include "sbox/config/config_file.h"
#include "sbox/core/digest.h"
#include "sbox/core/parallel.h"
#include "sbox/verification/verdict_model.h"

namespace sbox {
namespace {

std::uint64_t mapDigest(const Map& map) {
  const auto& cells = map.grid.getRawMap();
  return Digest()
      .add(map.width())
      .add(map.height())
      .add(map.resolution())
      .add(map.corner_in_map.x)
      .add(map.corner_in_map.y)
      .add(map.corner_in_map.phi)
      .add(cells.data(), cells.size() * sizeof(cells[0]))
      .value();
}

std::vector<std::uint64_t> mapDigests(const std::vector<Map>& maps, int threads) {
  std::vector<std::uint64_t> digests(maps.size());
  parallelFor(static_cast<int>(maps.size()), threads, [&](int i) {
    digests[static_cast<size_t>(i)] = mapDigest(maps[static_cast<size_t>(i)]);
  });
  return digests;
}

/// Of what decides which pairs are matched and how; what comes after may differ.
std::uint64_t optionsDigest(const MergeOptions& options) {
  MergeOptions matching;
  matching.method = options.method;
  matching.pair = options.pair;
  matching.paper = options.paper;
  matching.retrieval = options.retrieval;
  const std::string text = dumpConfig(matching) + SBOX_VERSION;
  Digest digest;
  const VerdictModel model;
  digest.add(text.data(), text.size())
      .add(model.weights.data(), sizeof(model.weights))
      .add(model.none);
  for (const InitialGuess& guess : options.initial) {
    digest.add(guess.map)
        .add(guess.pose.x)
        .add(guess.pose.y)
        .add(guess.pose.phi)
        .add(guess.sigma_xy)
        .add(guess.sigma_phi);
  }
  return digest.value();
}

/// Throws unless the shares are all that there are, each once.
void checkComplete(const std::vector<MatchedShare>& shares) {
  std::set<int> seen;
  for (size_t i = 0; i < shares.size(); ++i) {
    const PairShare& share = shares[i].share;
    const std::string name = std::to_string(share.number) + "/" + std::to_string(share.count);
    if (share.count != shares[0].share.count) {
      throw ShareError(i, "holds share " + name + ", but others are of " +
                              std::to_string(shares[0].share.count));
    }
    if (share.number < 1 || share.number > share.count) {
      throw ShareError(i, "holds share " + name + ", which there is not");
    }
    if (!seen.insert(share.number).second) {
      throw ShareError(i, "holds share " + name + ", which another file holds, too");
    }
  }
  for (int number = 1; number <= shares[0].share.count; ++number) {
    if (seen.count(number) == 0) {
      throw ShareError(0, "is of " + std::to_string(shares[0].share.count) + " shares, but share " +
                              std::to_string(number) + " is missing");
    }
  }
}

/// Whether the boxes that a pair counts as matched exist.
bool namesBoxesOf(const MapPair& pair, const MatchStore& store) {
  const auto count = [&](int map) {
    return static_cast<int>(featureSetOf(*store.features[static_cast<size_t>(map)]).boxes.size());
  };
  const int of_a = count(pair.a), of_b = count(pair.b);
  const auto& boxes = pair.result.matched_boxes;
  return std::all_of(boxes.begin(), boxes.end(), [&](const std::pair<int, int>& match) {
    return match.first >= 0 && match.first < of_a && match.second >= 0 && match.second < of_b;
  });
}

}  // namespace

MatchedShare matchShare(const std::vector<Map>& maps, const MergeOptions& options,
                        const PairShare& share, const ProgressFunction& tell) {
  if (maps.size() < 2 || share.number < 1 || share.number > share.count) {
    throw std::invalid_argument("a share needs at least two maps, and a number up to the count");
  }
  MatchStore store;
  extractAll(maps, options, store, tell);
  const std::vector<PairIndex> pairs = pairsToMatch(
      footprintsOf(maps, statesOf(options), options.threads), options, store, tell, share);
  matchPairs(pairs, options, store, tell);
  return {share, optionsDigest(options), mapDigests(maps, options.threads),
          matchedPairs(pairs, store)};
}

MatchStore joinShares(const std::vector<Map>& maps, const MergeOptions& options,
                      const std::vector<MatchedShare>& shares, const ProgressFunction& tell) {
  if (shares.empty()) {
    throw std::invalid_argument("there are no shares to join");
  }
  checkComplete(shares);
  const std::uint64_t options_digest = optionsDigest(options);
  const std::vector<std::uint64_t> map_digests = mapDigests(maps, options.threads);
  MatchStore store;
  extractAll(maps, options, store, tell);
  // By number, so that the order of the files never matters.
  std::vector<size_t> order(shares.size());
  for (size_t i = 0; i < shares.size(); ++i) {
    order[static_cast<size_t>(shares[i].share.number - 1)] = i;
  }
  for (const size_t i : order) {
    const MatchedShare& share = shares[i];
    if (share.options_digest != options_digest) {
      throw ShareError(i, "was made with other options, or by another version of sbox-merge");
    }
    if (share.map_digests != map_digests) {
      throw ShareError(i, "was made of other maps, or of these in another order");
    }
    for (const MapPair& pair : share.pairs) {
      if (pair.a < 0 || pair.a >= pair.b || pair.b >= static_cast<int>(maps.size()) ||
          !namesBoxesOf(pair, store)) {
        throw ShareError(i, "holds a pair of maps or boxes that do not exist");
      }
      store.results.emplace(PairIndex(pair.a, pair.b), pair.result);
    }
  }
  std::vector<PairIndex>& pairs = store.pairs.emplace();
  for (const auto& [pair, result] : store.results) {
    pairs.push_back(pair);
  }
  return store;
}

}  // namespace sbox
