// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox/placement/initial_guess.h"

namespace sbox {

/// Reads rough poses: a line each, `FILE x y phi sigma_xy sigma_phi` in metres and degrees, where
/// FILE is one of `names`, or what one of them alone ends in after a slash. Empty lines and those
/// that begin with # are skipped. Throws FileError naming the line that cannot be used.
[[nodiscard]] std::vector<InitialGuess> loadInitialGuesses(const std::string& path,
                                                           const std::vector<std::string>& names);

}  // namespace sbox
