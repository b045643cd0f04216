// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "sbox/adjustment/adjust_key_frames.h"
#include "sbox/fusion/fuse_maps.h"
#include "sbox/mapping/map_key_frames.h"
#include "sbox/match_pair.h"
#include "sbox/paper/paper_method.h"
#include "sbox/placement/place_maps.h"
#include "sbox/retrieval/choose_pairs.h"

namespace sbox {

/// How pairs of maps are matched.
enum class Method {
  Boxes,  ///< Corners and boxes propose, the cells decide; see match_pair.h.
  Paper   ///< The published method as it is printed; see paper_method.h.
};

/// Options of every stage.
struct MergeOptions {
  Method method = Method::Boxes;      ///< How pairs are matched.
  PairOptions pair;                   ///< For Method::Boxes.
  PaperOptions paper;                 ///< For Method::Paper.
  RetrievalOptions retrieval;         ///< Which pairs of many maps are matched at all.
  PlacementOptions placement;         ///< From pairs to groups.
  std::vector<InitialGuess> initial;  ///< Where some of the maps are thought to lie.
  MappingOptions mapping;        ///< For those who make the maps of scans; see map_key_frames.h.
  AdjustmentOptions adjustment;  ///< For those who do so; see map_adjusted.h.
  FusionOptions fusion;          ///< Its `threads` is replaced by the one below.
  std::optional<int> reference;  ///< Index of the map whose frame the merged map takes, if it can.
  /// Bend maps that have drifted so that their walls meet in the merged map; see bend_maps.h.
  bool bend = false;
  bool all_groups = false;  ///< Merge every group of two or more, not only the largest.
  int threads = 0;          ///< 0: one a core. Changes nothing but the time.
};

}  // namespace sbox
