// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "sbox/core/feature_set.h"
#include "sbox/core/state_grid.h"

namespace sbox::paper {

/// Length in metres of a wall from corner to corner as the cells show it, measured as the paper
/// does, between the cells at its two ends: along lines beside the wall, 0.15 to 0.45 m into the
/// room, from its middle to the first occupied cell on either side; the median of the lines.
/// `wall_in_map` says about where it lies, the room to its left. None if the middle is not free or
/// no wall ends within a metre of where it should.
[[nodiscard]] std::optional<double> wallLength(const StateGrid& grid,
                                               const LineSegment& wall_in_map);

}  // namespace sbox::paper
