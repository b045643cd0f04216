// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins placed maps into one grid (section 3.3). Every merged cell looks up what each map knows
// there (inverse warping), so no cell is left out; the reference map's cells are taken as they are.
#pragma once

#include <cstdint>
#include <vector>

#include "sbox/core/map.h"
#include "sbox/core/map_limits.h"
#include "sbox/core/state_grid.h"
#include "sbox/fusion/placed_map.h"

namespace sbox {

/// How evidence of several maps for one cell is joined.
enum class FusionRule {
  Table,   ///< The paper's Table 1; see table_rule.h.
  LogOdds  ///< Sum of the log-odds; see log_odds_rule.h.
};

/// How maps are fused.
struct FusionOptions {
  FusionRule rule = FusionRule::LogOdds;  ///< What maps that differ make of a cell.
  StateOptions states;  ///< Which cells count as free and occupied, for Table 1 and conflicts.
  double max_cells = max_map_cells;  ///< More merged cells than this are refused.
  int threads = 1;                   ///< 0: one a core. The result does not depend on it.
};

/// The fused map.
struct FusionResult {
  /// In the reference map's frame, on its lattice of cells (see lattice.h), and no larger than what
  /// any map knows; a single unknown cell if none knows anything.
  Map merged;
  std::size_t shared_cells = 0;  ///< Merged cells that two or more maps know.
  /// Those of them where maps conflict (see contested_cell.h), as x + y * width, ascending.
  std::vector<std::size_t> conflicts;
  double conflict_share = 0;  ///< Of the shared cells; 0 if nothing is shared.
};

/// Fuses `maps` in the frame of maps[reference], whose own pose is taken as zero. The order of the
/// other maps changes nothing. Throws std::invalid_argument if there is no map, a map is missing,
/// `reference` is out of range or a pose is not finite, and std::length_error if the merged map
/// would have more than max_cells cells.
[[nodiscard]] FusionResult fuseMaps(const std::vector<PlacedMap>& maps, std::size_t reference,
                                    const FusionOptions& options = {});

}  // namespace sbox
