// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Walls are found in coarse cells, that noise does not break them; here they move to where free
// space ends in the map's own cells.
#pragma once

#include "sbox/core/state_grid.h"
#include "sbox/features/wall_lines.h"

namespace sbox {

/// How far the edge of free space is looked for.
struct SharpenOptions {
  double reach = 0.2;     ///< Either side of a wall, metres.
  double along = 0.3;     ///< Either side of a wall point, over which its edge is averaged, metres.
  double outlier = 0.06;  ///< Places whose edge is this far from the median's are left out, metres.
};

/// Moves lines (offset and direction) and points (along their normals) to the edge of free space
/// in `cells`, whose frame the walls are in. What has no edge within reach stays where it was.
void sharpenWalls(const StateGrid& cells, Walls& walls, const SharpenOptions& options = {});

}  // namespace sbox
