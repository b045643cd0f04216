// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/core/pose.h"

namespace sbox {

/// Lower-left corner of cell (x, y), which may lie outside, of a grid whose cell (0, 0) has its
/// corner at `grid_corner`, in the same frame; lengths in metres.
[[nodiscard]] inline Pose2D cellCorner(const Pose2D& grid_corner, double resolution, int x, int y) {
  const Point2D corner = grid_corner.composePoint({x * resolution, y * resolution});
  return {corner.x, corner.y, grid_corner.phi};
}

}  // namespace sbox
