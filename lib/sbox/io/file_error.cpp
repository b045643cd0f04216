// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/file_error.h"

#include "sbox/core/one_line.h"

namespace sbox {

FileError::FileError(const std::string& path, const std::string& reason)
    : std::runtime_error(oneLine(path + ": " + reason)), path_(path), reason_(reason) {}

void throwTruncated(const std::string& path, const std::string& content) {
  throw FileError(path, "ends too early: the " + content + " is truncated");
}

}  // namespace sbox
