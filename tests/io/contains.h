// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// Whether the part is in the text: Catch2 names its own matcher for that by version.
inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
