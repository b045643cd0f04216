// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/core/map.h"

namespace sbox {

/// The map with its rows along the x axis of its frame: the smallest grid that covers it, each cell
/// with the value of the old cell that holds its centre, or unknown. Exact for quarter turns; at
/// other angles a wall can move by up to 0.7 cells and a lone cell can be lost or doubled.
[[nodiscard]] Map alignToAxes(const Map& map);

}  // namespace sbox
