// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/path_extension.h"

#include <filesystem>

#include "sbox/core/lower_case.h"

namespace sbox {

std::string pathExtension(const std::string& path) {
  const std::filesystem::path name = std::filesystem::path(path).filename();
  std::string extension = name.extension().string();
  if (lowerCase(extension) == ".gz") {
    extension = name.stem().extension().string() + extension;
  }
  return lowerCase(extension);
}

bool isYamlPath(const std::string& path) {
  const std::string extension = pathExtension(path);
  return extension == ".yaml" || extension == ".yml";
}

}  // namespace sbox
