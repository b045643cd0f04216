// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What merging gives: the merged maps, and all that led to them.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/feature_set.h"
#include "sbox/core/map.h"
#include "sbox/placement/place_maps.h"

namespace sbox {

/// How many of the maps were merged.
enum class MergeStatus {
  Merged,  ///< Every map is part of the merged map.
  Partly,  ///< Some are; they are merged.
  Refused  ///< No two maps belong together with confidence; nothing is merged.
};

/// "merged", "partly" or "refused".
[[nodiscard]] const char* toString(MergeStatus status);

/// What became of one input map.
struct MapOutcome {
  std::string name;        ///< Map::name.
  int width = 0;           ///< Cells in a row.
  int height = 0;          ///< Cells in a column.
  double resolution = 0;   ///< Edge length of a cell, in metres.
  bool placed = false;     ///< Part of the merged map (the main group's).
  MapPlacement placement;  ///< Its group, and where it lies in that.
  FeatureSet features;     ///< What was found in it.
};

/// The merged map of one group of two or more, in the frame of its reference.
struct MergedGroup {
  int group = 0;              ///< Number of the group, as in MapPlacement.
  int reference = 0;          ///< Index of the map whose frame the merged map has.
  std::vector<int> members;   ///< Indices of its maps, ascending.
  Map map;                    ///< The merged cells.
  double conflict_share = 0;  ///< Share of the cells known to several maps on which they differ.
  /// How far each member was bent, root mean square over its walls, metres; empty without bending.
  std::vector<double> shifts;
};

/// Wall time of each stage, in seconds. Matching, verification and refinement are sums over the
/// pairs that were matched in this call, which run side by side.
struct StageSeconds {
  double load = 0;          ///< Reading files; the caller's to fill in.
  double features = 0;      ///< Of all maps.
  double matching = 0;      ///< Summed over pairs.
  double verification = 0;  ///< Summed over pairs.
  double refinement = 0;    ///< Summed over pairs.
  double fusion = 0;        ///< Of all groups.
  double save = 0;          ///< Writing files; the caller's to fill in.
  double total = 0;         ///< From beginning to end.
};

/// The answer: what was merged, and why.
struct MergeResult {
  MergeStatus status = MergeStatus::Refused;  ///< How far it came.
  int reference = 0;                ///< Index of the map whose frame the main group is in.
  std::vector<MapOutcome> maps;     ///< In the order of the input.
  std::vector<MapPair> pairs;       ///< All, ordered by a, then b.
  std::vector<MergedGroup> merged;  ///< The main group first; the others if all were asked for.
  std::vector<OverruledGuess> overruled;  ///< As PlacementResult::overruled.
  StageSeconds seconds;                   ///< What it took.
};

}  // namespace sbox
