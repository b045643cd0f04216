// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sbox/io/file_bytes.h"

namespace sbox {

/// A PNG file without the chunks that say nothing about pixels (colour profiles, texts, times):
/// libpng warns about faults in those on stderr, and complains there about cut-off files. Throws
/// FileError naming `path` if a chunk is cut off, fails its checksum or if the last one is missing.
[[nodiscard]] Bytes essentialPngChunks(const std::string& path, const Bytes& png);

}  // namespace sbox
