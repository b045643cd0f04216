// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/retrieval/choose_pairs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "sbox/alignment/plausibility.h"

namespace sbox {

std::vector<PairIndex> allPairs(int map_count) {
  std::vector<PairIndex> pairs;
  for (int a = 0; a < map_count; ++a) {
    for (int b = a + 1; b < map_count; ++b) {
      pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

std::vector<PairIndex> choosePairs(int map_count, const std::vector<PairLikeness>& likeness,
                                   int partners, const PairShare& share) {
  std::vector<std::vector<double>> of_map(static_cast<size_t>(map_count));
  for (const PairLikeness& pair : likeness) {
    if (std::isfinite(pair.likeness) && pair.likeness > kImplausible) {
      of_map[static_cast<size_t>(pair.maps.first)].push_back(pair.likeness);
      of_map[static_cast<size_t>(pair.maps.second)].push_back(pair.likeness);
    }
  }
  // Of each map, the likeness of the last partner that it takes.
  std::vector<double> least(of_map.size(), kImplausible);
  for (size_t map = 0; map < of_map.size(); ++map) {
    std::vector<double>& known = of_map[map];
    if (!share.holds(static_cast<int>(map))) {
      least[map] = std::numeric_limits<double>::infinity();
    } else if (partners > 0 && known.size() > static_cast<size_t>(partners)) {
      const auto last = known.begin() + (partners - 1);
      std::nth_element(known.begin(), last, known.end(), std::greater<>());
      least[map] = *last;
    }
  }
  std::vector<PairIndex> chosen;
  for (const PairLikeness& pair : likeness) {
    const double needed = std::min(least[static_cast<size_t>(pair.maps.first)],
                                   least[static_cast<size_t>(pair.maps.second)]);
    if (pair.likeness > kImplausible && pair.likeness >= needed) {
      chosen.push_back(pair.maps);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace sbox
