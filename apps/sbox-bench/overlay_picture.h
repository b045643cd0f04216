// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sbox-bench/run_method.h"

namespace sbox::bench {

/// Writes a PNG that shows the two maps under the answer and, beside it, under the truth: walls of
/// a in red, of b in blue, free space of both in white; above it what was answered and why. Maps
/// without a pose or a truth are shown apart. Throws std::runtime_error with "PATH: reason".
void writeOverlay(const std::string& path, const LoadedFolder& loaded, size_t pair,
                  const Answer& answer);

}  // namespace sbox::bench
