// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps of a folder of annotated pairs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sbox-bench/annotated_pairs.h"
#include "sbox/core/map.h"

namespace sbox::bench {

/// Which pairs of a folder are taken.
struct PairChoice {
  std::string only;  ///< Those whose "folder group a b" holds this text ...
  int every = 1;     ///< ... and of these each N-th.
};

/// The pairs to run with their maps in memory.
struct LoadedFolder {
  PairFolder folder;                             ///< With the chosen pairs only.
  std::vector<Map> maps;                         ///< Each map once.
  std::vector<std::pair<int, int>> map_of_pair;  ///< Indices of a and b in `maps`.
};

/// Keeps the chosen pairs and loads their maps, `threads` (0: one a core) at a time.
[[nodiscard]] LoadedFolder loadFolder(PairFolder folder, const PairChoice& choice = {},
                                      int threads = 1);

}  // namespace sbox::bench
