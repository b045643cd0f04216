// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which pairs of many maps are worth matching: of each map, those with the maps that look most like
// it.
#pragma once

#include <vector>

#include "sbox/core/pair_result.h"
#include "sbox/retrieval/pair_likeness.h"

namespace sbox {

/// Which pairs are matched.
struct RetrievalOptions {
  int partners = 20;         ///< Maps that each is matched with at least; 0: all.
  LikenessOptions likeness;  ///< Which those are.
};

/// A part of the maps, or of the pairs, so that several machines can work side by side: every
/// count-th by index, from number - 1.
struct PairShare {
  int number = 1;  ///< From 1 to count.
  int count = 1;   ///< Of shares.

  /// Whether the map or pair with this index, from 0, is in the share.
  [[nodiscard]] bool holds(int index) const { return index % count == number - 1; }
};

/// How alike two maps look; see pairLikeness().
struct PairLikeness {
  PairIndex maps;       ///< Which.
  double likeness = 0;  ///< Higher is more alike.
};

/// Every pair of so many maps, in ascending order.
[[nodiscard]] std::vector<PairIndex> allPairs(int map_count);

/// The pairs that are among the `partners` most alike of one of their maps, as are those just as
/// alike; further those of infinite likeness, and none that is implausible. Only maps of the share
/// choose, so that all shares together choose what one would. In ascending order.
[[nodiscard]] std::vector<PairIndex> choosePairs(int map_count,
                                                 const std::vector<PairLikeness>& likeness,
                                                 int partners, const PairShare& share = {});

}  // namespace sbox
