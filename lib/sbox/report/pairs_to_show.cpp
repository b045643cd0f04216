// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/pairs_to_show.h"

#include <algorithm>

namespace sbox {

std::vector<const MapPair*> pairsToShow(const MergeResult& result) {
  std::vector<const MapPair*> best(result.maps.size(), nullptr);
  for (const MapPair& pair : result.pairs) {
    if (!pair.result.has_pose) {
      continue;
    }
    for (const int map : {pair.a, pair.b}) {
      const MapPair*& known = best[static_cast<size_t>(map)];
      if (known == nullptr || pair.result.confidence > known->result.confidence) {
        known = &pair;
      }
    }
  }
  std::vector<const MapPair*> shown;
  for (const MapPair& pair : result.pairs) {
    if (std::find(best.begin(), best.end(), &pair) != best.end()) {
      shown.push_back(&pair);
    }
  }
  return shown;
}

}  // namespace sbox
