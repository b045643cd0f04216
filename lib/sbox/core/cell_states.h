// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The state of a map's cells, and where its known ones are, without a copy of the map.
#pragma once

#include <array>

#include "sbox/core/state_grid.h"

namespace sbox {

/// The state of each value that a cell can have.
class CellStates {
 public:
  /// By these limits.
  explicit CellStates(const StateOptions& options = {});
  /// The state of a cell of this value.
  [[nodiscard]] CellState operator()(mrpt::maps::COccupancyGridMap2D::cellType cell) const {
    return states_[static_cast<std::uint8_t>(cell)];
  }

 private:
  std::array<CellState, 256> states_{};  ///< By the bits of the value.
};

/// The least rectangle that holds all known cells of a map; of no width if there are none.
struct KnownPart {
  int x_first = 0;  ///< Its first column.
  int y_first = 0;  ///< Its first row.
  int width = 0;    ///< Its columns.
  int height = 0;   ///< Its rows.
};

/// The known part of a map, by these states.
[[nodiscard]] KnownPart knownPart(const Map& map, const CellStates& states);

/// Lower-left corner of the part, in the map frame, along the grid's axes.
[[nodiscard]] Pose2D cornerInMap(const Map& map, const KnownPart& part);

}  // namespace sbox
