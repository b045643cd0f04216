// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace sbox::dataset {

/// Makes a folder and those it lies in, where they are not there. Throws std::runtime_error.
inline void makeFolder(const std::string& folder) {
  std::error_code reason;
  std::filesystem::create_directories(folder, reason);
  if (reason) {
    throw std::runtime_error(folder + ": cannot be made: " + reason.message());
  }
}

}  // namespace sbox::dataset
