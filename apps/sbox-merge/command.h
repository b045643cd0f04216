// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The whole command, but for the SLAM that robots' logs need.
#pragma once

#include <functional>

#include "sbox/core/progress.h"

namespace sbox::app {

struct Arguments;
struct Inputs;

/// Fills in the key frames of those inputs that are logs. Throws FileError if one cannot be mapped.
using RunSlams = std::function<void(const Arguments&, const ProgressFunction&, Inputs&)>;

/// Returns the exit code.
[[nodiscard]] int command(int argc, const char* const* argv, const RunSlams& run_slams);

}  // namespace sbox::app
