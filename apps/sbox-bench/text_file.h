// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sbox::bench {

/// Writes text to a file. Throws std::runtime_error with "PATH: reason".
void writeText(const std::string& path, const std::string& text);

}  // namespace sbox::bench
