// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"

namespace sbox {

/// Output files that appear all together or not at all.
///
/// Each is written under a temporary name in the folder of its target; commit() renames them. What
/// has not been committed is removed by the destructor, so also when an exception passes.
///
///     OutputFiles files;
///     files.writeBytes("report.json", text);
///     files.write("merged.png", [&](const std::string& temporary) { draw(temporary); });
///     files.commit();
class OutputFiles {
 public:
  OutputFiles() = default;
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;
  ~OutputFiles();

  /// From here on stage() refuses this file, with the reason: it is read, and would be lost.
  void protect(const std::string& path, const std::string& reason);

  /// Makes an empty file beside `target`, with the same extension, and returns its path. Throws
  /// FileError naming the target if its folder is missing or cannot be written, if there is
  /// something else than a writable regular file in its place, or if it is protected or has been
  /// staged before.
  /// A symbolic link is followed.
  std::string stage(const std::string& target);

  /// Stages `target` and calls fill() with the path that stage() returned. What a FileError of it
  /// says is said of the target, the name that the user knows.
  template <typename Fill>
  void write(const std::string& target, const Fill& fill) {
    const std::string temporary = stage(target);
    try {
      fill(temporary);
    } catch (const FileError& error) {
      throw FileError(target, error.reason());
    }
  }

  /// The same with these bytes as the contents, of a vector or a string.
  template <typename Contents>
  void writeBytes(const std::string& target, const Contents& contents) {
    write(target, [&](const std::string& temporary) {
      writeFile(temporary, Bytes(contents.begin(), contents.end()));
    });
  }

  /// Puts all staged files in their places, replacing what is there. Throws FileError, before the
  /// first one is replaced where that can be told.
  void commit();

  /// Removes all staged files.
  void discard() noexcept;

 private:
  struct Staged {
    std::string temporary;
    std::string target;
    std::string given;  ///< The target as the caller named it.
  };

  struct Protected {
    std::string path;
    std::string reason;
  };

  std::mutex mutex_;
  std::vector<Protected> protected_;
  std::vector<Staged> staged_;
};

}  // namespace sbox
