// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CFileGZInputStream.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "sbox/io/file_error.h"

namespace sbox {

/// Bytes of a file, decompressed on the way if they are compressed.
class GzipReader {
 public:
  /// Throws FileError if the file cannot be opened.
  explicit GzipReader(const std::string& path) : path_(path) {
    if (!stream_.open(path)) {
      throw FileError(path, "cannot be read");
    }
  }
  /// Fills as much of the memory as the file can; returns how many bytes. Throws FileError where
  /// compressed data is damaged.
  std::size_t read(void* memory, std::size_t size) {
    // zlib's -1 for damaged data comes out as a huge count.
    const std::size_t count = stream_.Read(memory, size);
    if (count > size) {
      throw FileError(path_, "is damaged: its compressed data cannot be read");
    }
    total_ += count;
    return count;
  }
  /// Bytes read so far, after decompression.
  [[nodiscard]] std::uint64_t total() const { return total_; }

 private:
  std::string path_;
  mrpt::io::CFileGZInputStream stream_;
  std::uint64_t total_ = 0;
};

}  // namespace sbox
