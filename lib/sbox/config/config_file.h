// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sbox/merge_options.h"

namespace sbox {

/// Sets the options that the ini file names and leaves the others. Throws FileError, with the line,
/// if the file cannot be read or holds what is no option.
void loadConfig(const std::string& path, MergeOptions& options);

/// All options as an ini file, with units, ranges and meanings; loadConfig reads it back.
[[nodiscard]] std::string dumpConfig(const MergeOptions& options);

}  // namespace sbox
