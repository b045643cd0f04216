// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/core/state_limits.h"

using namespace sbox;

TEST_CASE("limits part the log-odds where the probabilities say") {
  using Grid = mrpt::maps::COccupancyGridMap2D;
  for (const StateOptions& options :
       {StateOptions(), StateOptions{0.9, 0.1}, StateOptions{0.51, 0.49}}) {
    const StateLimits limits = stateLimits(options);
    for (int value = -127; value <= 127; ++value) {
      const auto cell = static_cast<CellLogOdds>(value);
      const double p_free = Grid::l2p(cell);
      const CellState expected = p_free >= options.free_above      ? CellState::Free
                                 : p_free < options.occupied_below ? CellState::Occupied
                                                                   : CellState::Unknown;
      CHECK(limits.stateOf(cell) == expected);
      CHECK(limits.knows(cell) == (expected != CellState::Unknown));
    }
  }
}

TEST_CASE("cells as sure as can be are known, and those that say nothing are not") {
  const StateLimits strict = stateLimits({1, 0});
  CHECK(strict.stateOf(127) == CellState::Free);
  CHECK(strict.stateOf(126) == CellState::Unknown);
  CHECK(strict.stateOf(-126) == CellState::Unknown);
  CHECK(strict.stateOf(-127) == CellState::Occupied);
  const StateLimits lax = stateLimits({0.5, 0.5});
  CHECK(lax.stateOf(1) == CellState::Free);
  CHECK(lax.stateOf(0) == CellState::Unknown);
  CHECK(lax.stateOf(-1) == CellState::Occupied);
}
