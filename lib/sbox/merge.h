// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From maps to merged map: the whole method as one function.
#pragma once

#include <optional>
#include <vector>

#include "sbox/core/map.h"
#include "sbox/fusion/fuse_maps.h"
#include "sbox/mapping/map_key_frames.h"
#include "sbox/match_pair.h"
#include "sbox/merge_result.h"
#include "sbox/paper/paper_method.h"
#include "sbox/placement/place_maps.h"
#include "sbox/progress.h"

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
  PlacementOptions placement;         ///< From pairs to groups.
  std::vector<InitialGuess> initial;  ///< Where some of the maps are thought to lie.
  MappingOptions mapping;        ///< For those who make the maps of scans; see map_key_frames.h.
  FusionOptions fusion;          ///< Its `threads` is replaced by the one below.
  std::optional<int> reference;  ///< Index of the map whose frame the merged map takes, if it can.
  bool all_groups = false;       ///< Merge every group of two or more, not only the largest.
  int threads = 0;               ///< 0: one a core. Changes nothing but the time.
};

/// Merges the maps that belong together. The merged map is that of the largest group, in the frame
/// of options.reference where that is a member, else of the group's first map. Maps are named by
/// their `name`. Throws std::invalid_argument with less than two maps or a reference that is not
/// one of them, and std::length_error if a merged map would be too large (see FusionOptions).
[[nodiscard]] MergeResult mergeMaps(const std::vector<Map>& maps, const MergeOptions& options = {},
                                    const ProgressFunction& progress = {});

}  // namespace sbox
