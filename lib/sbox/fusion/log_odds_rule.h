// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdlib>

#include "sbox/fusion/contested_cell.h"

namespace sbox {

/// Fusion by probability, the paper's own future work (section 5), for a cell on which maps
/// disagree: the sum of the maps' net log-odds, in which a map weighs less the nearer the edge of
/// its own wall passes. Two views of one wall that differ by a part of a cell then leave one wall.
///
/// Evidence that cancels to within a sixteenth says nothing. Such a cell is settled as in Table 1,
/// as occupied, with a probability of 0.27 of being free, so that maps that only know 0 and 1 leave
/// no holes in walls.
[[nodiscard]] inline int settleByLogOdds(const ContestedCell& cell) {
  constexpr int kOccupied = -16;
  const int sum = cell.net_free + cell.net_occupied;
  const bool cancelled = 16 * std::abs(sum) <= cell.net_free - cell.net_occupied;
  return cancelled ? std::max(kOccupied, cell.most_occupied) : sum;
}

}  // namespace sbox
