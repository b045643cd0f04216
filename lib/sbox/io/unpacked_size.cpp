// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/unpacked_size.h"

#include <mrpt/io/CFileGZInputStream.h>

#include <exception>

#include "sbox/io/file_bytes.h"

namespace sbox {

std::uint64_t unpackedSize(const std::string& path) {
  std::uint64_t total = 0;
  try {
    mrpt::io::CFileGZInputStream in(path);
    Bytes piece(1 << 20);
    for (;;) {
      // zlib's -1 for damaged data comes out as a huge count.
      const std::size_t count = in.Read(piece.data(), piece.size());
      if (count == 0 || count > piece.size()) {
        break;
      }
      total += count;
    }
  } catch (const std::exception&) {
    // Missing, or damaged from here on.
  }
  return total;
}

}  // namespace sbox
