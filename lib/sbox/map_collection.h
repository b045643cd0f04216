// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps that come one by one, or are mapped anew while robots drive on: what has not changed is not
// done again.
#pragma once

#include <vector>

#include "sbox/core/map.h"
#include "sbox/core/progress.h"
#include "sbox/match_all.h"
#include "sbox/merge_options.h"
#include "sbox/merge_result.h"

namespace sbox {

/// A growing set of maps. Each map costs its features once, and each pair is matched once, however
/// often the maps are merged; the result equals mergeMaps() of all of them.
class MapCollection {
 public:
  /// An empty set, to be merged by these options.
  explicit MapCollection(MergeOptions options = {});

  /// Adds a map and gives its index.
  int add(Map map);
  /// Puts another map in the place of the one with this index; throws std::out_of_range if there is
  /// none.
  void replace(int index, Map map);
  /// All maps, by index.
  [[nodiscard]] const std::vector<Map>& maps() const { return maps_; }
  /// Merges the maps as mergeMaps() does, and throws as it does.
  [[nodiscard]] MergeResult merge(const ProgressFunction& progress = {});

 private:
  MergeOptions options_;
  std::vector<Map> maps_;
  MatchStore known_;  ///< Nothing of a pair with a map that was replaced since.
};

}  // namespace sbox
