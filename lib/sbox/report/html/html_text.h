// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text and bytes as HTML holds them.
#pragma once

#include <string>
#include <vector>

namespace sbox::html {

/// The text with HTML's own characters escaped, for use between tags and in quoted attributes.
/// Bytes that are not UTF-8 and control characters are replaced.
[[nodiscard]] std::string escaped(const std::string& text);

/// "data:image/png;base64,..." for the bytes of a PNG file.
[[nodiscard]] std::string pngUri(const std::vector<unsigned char>& png);

}  // namespace sbox::html
