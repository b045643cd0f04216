// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace sbox {

/// Output files that appear all together or not at all.
///
/// Each is written under a temporary name in the folder of its target; commit() renames them. What
/// has not been committed is removed by the destructor, so also when an exception passes.
///
///     OutputFiles files;
///     write(files.stage("merged.png"));
///     files.commit();
class OutputFiles {
 public:
  OutputFiles() = default;
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;
  ~OutputFiles();

  /// Makes an empty file beside `target`, with the same extension, and returns its path. Throws
  /// FileError naming the target if its folder is missing or cannot be written, if there is
  /// something else than a writable regular file in its place, or if it has been staged before.
  /// A symbolic link is followed.
  std::string stage(const std::string& target);

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

  std::mutex mutex_;
  std::vector<Staged> staged_;
};

}  // namespace sbox
