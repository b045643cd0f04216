// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/fusion/state_limits.h"

namespace sbox {

StateLimits stateLimits(const StateOptions& options) {
  using Grid = mrpt::maps::COccupancyGridMap2D;
  StateLimits limits{128, -128};
  for (int value = 127; value > 0; --value) {
    if (Grid::l2p(static_cast<Grid::cellType>(value)) >= options.free_above) {
      limits.free_from = value;
    }
    if (Grid::l2p(static_cast<Grid::cellType>(-value)) < options.occupied_below) {
      limits.occupied_to = -value;
    }
  }
  return limits;
}

}  // namespace sbox
