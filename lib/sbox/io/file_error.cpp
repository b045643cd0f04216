// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/file_error.h"

#include <algorithm>

namespace sbox {
namespace {

/// File names and file contents may hold line breaks; an error message may not.
std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
  return text;
}

}  // namespace

FileError::FileError(const std::string& path, const std::string& reason)
    : std::runtime_error(oneLine(path + ": " + reason)), path_(path), reason_(reason) {}

void throwTruncated(const std::string& path, const std::string& content) {
  throw FileError(path, "ends too early: the " + content + " is truncated");
}

}  // namespace sbox
