// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox-merge/arguments.h"
#include "sbox-merge/command.h"

namespace sbox::app {

/// Loads, merges, writes and tells. Returns 0 if every map is part of the merged map, else 3.
/// Throws FileError, Interrupted, and what mergeMaps throws.
[[nodiscard]] int run(const Arguments& arguments, const RunSlams& run_slams);

}  // namespace sbox::app
