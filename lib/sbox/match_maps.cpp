// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/match_maps.h"

#include <utility>

namespace sbox {
namespace {

template <typename Extract, typename Match>
MatchedPair matched(const Map& map_a, const Map& map_b, const Extract& extract,
                    const Match& match) {
  auto a = extract(map_a);
  auto b = extract(map_b);
  return {match(a, b), std::move(a.feature_set), std::move(b.feature_set)};
}

}  // namespace

MatchedPair matchMaps(const Map& a, const Map& b, const MergeOptions& options) {
  if (options.method == Method::Boxes) {
    return matched(
        a, b, [&](const Map& map) { return extractFeatures(map, options.pair.features); },
        [&](const MapFeatures& of_a, const MapFeatures& of_b) {
          return matchPair(of_a, of_b, options.pair);
        });
  }
  return matched(
      a, b, [&](const Map& map) { return extractPaperFeatures(map, options.paper); },
      [&](const PaperFeatures& of_a, const PaperFeatures& of_b) {
        return matchPaper(of_a, of_b, options.paper);
      });
}

}  // namespace sbox
