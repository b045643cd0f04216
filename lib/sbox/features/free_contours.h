// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The outlines of free space. A wall shows as the place where free cells end at occupied ones, so
// that its side is known; where they end at unknown cells is only where the robot stopped looking.
#pragma once

#include <vector>

#include "sbox/core/state_grid.h"

namespace sbox {

/// A free cell at the edge of free space.
struct ContourCell {
  int x = 0;             ///< Column.
  int y = 0;             ///< Row, upwards.
  bool at_wall = false;  ///< An occupied cell lies next to it or behind one unknown cell.
};

/// A closed walk along the edge of free space, cell by cell, free space on the left.
using FreeContour = std::vector<ContourCell>;

/// Which outlines are kept.
struct ContourOptions {
  int min_cells = 4;  ///< Shorter contours are specks.
  /// Whether two free cells that only touch at a corner, between two that are not free, count as
  /// wall. It parts what a slanted wall parts, and moves the outline by up to a cell there.
  bool close_corners = true;
};

/// All outlines of the grid's free cells, outer and inner.
[[nodiscard]] std::vector<FreeContour> traceFreeContours(const StateGrid& grid,
                                                         const ContourOptions& options = {});

}  // namespace sbox
