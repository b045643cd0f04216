// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace sbox {

/// Bytes of a file after decompression, if it is compressed by gzip; of a damaged one, up to the
/// damage. It is read through, a piece at a time; 0 if it cannot be read.
[[nodiscard]] std::uint64_t unpackedSize(const std::string& path);

}  // namespace sbox
