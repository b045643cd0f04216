// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where along a line is wall?
#pragma once

#include <vector>

#include "sbox/core/state_grid.h"

namespace sbox {

/// Occupied cells beside a line without a large gap between them.
struct WallStretch {
  double begin = 0;           ///< Position along the line, metres: -x sin(theta) + y cos(theta).
  double end = 0;             ///< Where it ends.
  std::vector<size_t> cells;  ///< Indices into the grid's cells.
};

/// What counts as wall along a line.
struct StretchOptions {
  double min_length = 1.5;   ///< Shorter stretches are left out, metres.
  double max_gap = 0.3;      ///< Holes up to this do not end a stretch, metres.
  double wall_width = 0.15;  ///< Cells within half of this of the line belong to it, metres.
};

/// The stretches of occupied cells along the line x cos(theta) + y sin(theta) = rho of the grid
/// frame, in order.
[[nodiscard]] std::vector<WallStretch> findWallStretches(const StateGrid& grid, double theta,
                                                         double rho, const StretchOptions& options);

}  // namespace sbox
