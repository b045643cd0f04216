// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/unpacked_size.h"

#include <exception>

#include "sbox/io/file_bytes.h"
#include "sbox/io/gzip_reader.h"

namespace sbox {

std::uint64_t unpackedSize(const std::string& path) {
  std::uint64_t total = 0;
  try {
    GzipReader reader(path);
    Bytes piece(1 << 20);
    while (reader.read(piece.data(), piece.size()) > 0) {
      total = reader.total();
    }
  } catch (const std::exception&) {
    // Missing, or damaged from here on.
  }
  return total;
}

}  // namespace sbox
