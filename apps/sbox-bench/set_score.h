// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Many maps in one call: how right the poses of whole groups are.
#pragma once

#include <string>
#include <vector>

#include "sbox-bench/annotated_pairs.h"
#include "sbox-bench/table.h"

namespace sbox::bench {

/// Maps that go into one call together.
struct MapSet {
  std::string name;
  std::vector<std::string> maps;  ///< As pairs.json calls them.
};

/// All maps of the folder as one set and, where it holds a sets.json, the sets named there. Throws
/// std::runtime_error with "PATH: reason" if that is not in the format.
[[nodiscard]] std::vector<MapSet> readSets(const PairFolder& folder);

/// How one call did: annotated pairs of maps in the set, by the poses of their group.
struct SetScore {
  size_t maps = 0;
  size_t groups = 0;   ///< Of one map or more.
  size_t right = 0;    ///< By the rule of judge.h.
  size_t wrong = 0;    ///< Pairs with nothing in common in one group are wrong, too.
  size_t apart = 0;    ///< Belong together, but are in different groups.
  size_t pairs = 0;    ///< Annotated.
  double seconds = 0;  ///< Of mergeMaps, without reading files.
};

/// Merges the maps of the set with the default options. `threads` 0: one a core.
[[nodiscard]] SetScore scoreSet(const PairFolder& folder, const MapSet& set, int threads);

/// A row for each set of each folder.
[[nodiscard]] Table setTable(const std::vector<PairFolder>& folders, int threads);

}  // namespace sbox::bench
