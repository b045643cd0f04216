// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/core/state_grid.h"

namespace sbox {

/// StateOptions' probabilities as MRPT's log-odds: free from `free_from` on, occupied up to
/// `occupied_to`.
struct StateLimits {
  int free_from = 1;     ///< Log-odds of a cell that is just free.
  int occupied_to = -1;  ///< Log-odds of a cell that is just occupied.
};

/// The limits for these probabilities.
[[nodiscard]] StateLimits stateLimits(const StateOptions& options);

}  // namespace sbox
