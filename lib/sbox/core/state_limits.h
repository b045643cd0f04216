// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a cell counts as, told from its log-odds alone.
#pragma once

#include "sbox/core/state_grid.h"

namespace sbox {

/// A map's cells: MRPT's log-odds of being free, in a byte.
using CellLogOdds = mrpt::maps::COccupancyGridMap2D::cellType;

/// StateOptions' probabilities as log-odds.
struct StateLimits {
  CellLogOdds free_from = 1;     ///< Log-odds of a cell that is just free.
  CellLogOdds occupied_to = -1;  ///< Log-odds of a cell that is just occupied.

  /// The state of a cell.
  [[nodiscard]] CellState stateOf(CellLogOdds cell) const {
    return cell >= free_from     ? CellState::Free
           : cell <= occupied_to ? CellState::Occupied
                                 : CellState::Unknown;
  }
  /// Whether a cell is free or occupied.
  [[nodiscard]] bool knows(CellLogOdds cell) const {
    return cell >= free_from || cell <= occupied_to;
  }
};

/// The limits for these probabilities. Cells as likely free as occupied are never known, and those
/// that are as sure as MRPT's cells can be always are.
[[nodiscard]] StateLimits stateLimits(const StateOptions& options);

}  // namespace sbox
