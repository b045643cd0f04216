// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What loading, saving and drawing cost alone: the floor that a method's time is held against, in
// the same run on the same machine.
#pragma once

#include <vector>

#include "sbox-bench/score_table.h"

namespace sbox::bench {

/// Wall time for one map, in seconds, least over the repeats.
struct FloorSeconds {
  double load = 0;  ///< From a .gridmap, whatever format the map came in.
  double save = 0;  ///< As .gridmap.
  double draw = 0;  ///< As .png.
};

/// Measures each map of a folder, one after the other, through files in a temporary folder.
[[nodiscard]] std::vector<FloorSeconds> measureFloor(const LoadedFolder& loaded, int repeat);

/// One row a stage: its time and its ratio to the floor of the pair (loading both maps, saving and
/// drawing the larger one), median and largest over the pairs. `floors` has one entry a folder.
[[nodiscard]] Table ratioTable(const MethodRun& run,
                               const std::vector<std::vector<FloorSeconds>>& floors);

}  // namespace sbox::bench
