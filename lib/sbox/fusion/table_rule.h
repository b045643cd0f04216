// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/fusion/contested_cell.h"

namespace sbox {

/// Table 1 (section 3.3) for a cell on which maps disagree: unknown gives way to any known state,
/// occupied against free becomes occupied. The cell takes the strongest log-odds of the state that
/// wins; where no map is sure of its state, occupied wins too.
[[nodiscard]] inline int settleByTable(const ContestedCell& cell, const StateLimits& limits) {
  const bool only_free_is_sure =
      cell.most_occupied > limits.occupied_to && cell.most_free >= limits.free_from;
  return only_free_is_sure ? cell.most_free : cell.most_occupied;
}

}  // namespace sbox
