// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the real command, as a user would.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sbox::test {

struct Outcome {
  int exit_code = 0;
  std::string out;
  std::string err;
};

/// Runs sbox-merge with these arguments in `folder`, after the shell has run `before`.
Outcome runMerge(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                 const std::string& before = "true");

/// The bytes of a file; empty if it is not there.
std::string contents(const std::filesystem::path& path);

/// Names of what lies in the folder, sorted, hidden files too.
std::vector<std::string> listing(const std::filesystem::path& folder);

/// An empty folder that goes with its content at the end of the test.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Makes calls of the command that begin with these words.
inline auto beginningWith(const std::vector<std::string>& words) {
  return [words](const std::vector<std::string>& more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
}

}  // namespace sbox::test
