// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace sbox {

/// A file that cannot be read or written. what() is one line: "PATH: reason".
class FileError : public std::runtime_error {
 public:
  /// what() becomes "path: reason".
  FileError(const std::string& path, const std::string& reason);

  /// The file, as it was given.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// What is wrong with it and what to do, without the path.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  std::string path_;
  std::string reason_;
};

/// Reason of a FileError where a std::bad_alloc was met.
inline constexpr const char* no_memory = "does not fit into memory, or is damaged";

/// Throws the FileError of a file whose content, say "image", has no end.
[[noreturn]] void throwTruncated(const std::string& path, const std::string& content);

}  // namespace sbox
