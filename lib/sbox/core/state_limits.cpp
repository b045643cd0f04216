// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/state_limits.h"

namespace sbox {

static_assert(sizeof(CellLogOdds) == 1, "MRPT was built with 16-bit cells");

StateLimits stateLimits(const StateOptions& options) {
  using Grid = mrpt::maps::COccupancyGridMap2D;
  StateLimits limits;
  // The probability grows with the log-odds.
  while (limits.free_from < 127 && Grid::l2p(limits.free_from) < options.free_above) {
    ++limits.free_from;
  }
  while (limits.occupied_to > -127 && Grid::l2p(limits.occupied_to) >= options.occupied_below) {
    --limits.occupied_to;
  }
  return limits;
}

}  // namespace sbox
