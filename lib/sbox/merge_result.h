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

enum class MergeStatus {
  Merged,  ///< Every map is part of the merged map.
  Partly,  ///< Some are; they are merged.
  Refused  ///< No two maps belong together with confidence; nothing is merged.
};

/// "merged", "partly" or "refused".
[[nodiscard]] const char* toString(MergeStatus status);

/// What became of one input map.
struct MapOutcome {
  std::string name;
  int width = 0;          ///< Cells in a row.
  int height = 0;         ///< Cells in a column.
  double resolution = 0;  ///< Edge length of a cell, in metres.
  bool placed = false;    ///< Part of the merged map (the main group's).
  MapPlacement placement;
  FeatureSet features;
};

/// The merged map of one group of two or more, in the frame of its reference.
struct MergedGroup {
  int group = 0;
  int reference = 0;
  std::vector<int> members;
  Map map;
  double conflict_share = 0;  ///< Share of the cells known to several maps on which they differ.
};

/// Wall time of each stage, in seconds. Matching, verification and refinement are sums over pairs,
/// which run side by side.
struct StageSeconds {
  double load = 0;
  double features = 0;
  double matching = 0;
  double verification = 0;
  double refinement = 0;
  double fusion = 0;
  double save = 0;
  double total = 0;
};

struct MergeResult {
  MergeStatus status = MergeStatus::Refused;
  int reference = 0;                ///< Index of the map whose frame the main group is in.
  std::vector<MapOutcome> maps;     ///< In the order of the input.
  std::vector<MapPair> pairs;       ///< All, ordered by a, then b.
  std::vector<MergedGroup> merged;  ///< The main group first; the others if all were asked for.
  StageSeconds seconds;
};

}  // namespace sbox
