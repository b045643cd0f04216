// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/path_extension.h"

#include <algorithm>
#include <filesystem>

namespace sbox {

std::string pathExtension(const std::string& path) {
  const std::filesystem::path name = std::filesystem::path(path).filename();
  std::string extension = name.extension().string();
  const auto lower = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
  };
  if (lower(extension) == ".gz") {
    extension = name.stem().extension().string() + extension;
  }
  return lower(extension);
}

}  // namespace sbox
