// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sbox/core/state_limits.h"
#include "sbox/fusion/map_layer.h"

namespace sbox {

/// What maps that disagree say about one merged cell. Only sums and extremes of whole numbers, so
/// the order of the maps changes nothing.
struct ContestedCell {
  int net_free = 0;       ///< Sum of the positive CellEvidence::net.
  int net_occupied = 0;   ///< Sum of the negative CellEvidence::net.
  int most_free = 0;      ///< Greatest positive CellEvidence::whole.
  int most_occupied = 0;  ///< Least negative CellEvidence::whole.
  /// One map says occupied, and another free with no occupied cell of its own within one cell
  /// around. That one cell lets two views of one wall lie a part of a cell apart without being
  /// called a conflict.
  bool conflict = false;
};

/// Asks every map about lattice cell (x, y).
[[nodiscard]] ContestedCell contestedCell(const std::vector<MapLayer>& layers, int x, int y,
                                          const StateLimits& limits);

}  // namespace sbox
