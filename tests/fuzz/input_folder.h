// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "sbox/io/file_bytes.h"

namespace sbox::fuzz {

/// A folder in memory where there is one, for inputs as files; gone at the end.
class InputFolder {
 public:
  InputFolder() {
    const bool in_memory = std::filesystem::is_directory("/dev/shm");
    std::string name = std::string(in_memory ? "/dev/shm" : "/tmp") + "/sbox-fuzz-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) {
      std::abort();
    }
    folder_ = name;
  }
  ~InputFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;

  /// Writes the file anew and returns its path.
  std::string write(const std::string& name, const Bytes& bytes) const {
    std::string path = folder_ + "/" + name;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return path;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }

 private:
  std::string folder_;
};

/// Ends the run where a rule does not hold, so that the fuzzer keeps the input.
inline void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

}  // namespace sbox::fuzz
