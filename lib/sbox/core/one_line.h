// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sbox {

/// The text with "?" for each control character, line breaks among them: file names and what files
/// hold may have such, messages and comments may not.
[[nodiscard]] std::string oneLine(std::string text);

}  // namespace sbox
