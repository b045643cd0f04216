// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/output_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "sbox/io/file_error.h"
#include "sbox/io/path_extension.h"

namespace sbox {
namespace fs = std::filesystem;
namespace {

constexpr const char* kNotRegular = "cannot be written: it is not a regular file";

std::string errorText(int error) { return std::strerror(error); }

/// Where the file will really lie, with links resolved and the folder written out, so that two
/// names of one place compare equal.
fs::path resolve(const std::string& target) {
  std::error_code error;
  fs::path path = target;
  if (fs::is_symlink(path, error)) {
    const bool is_special = fs::exists(path, error) && fs::is_other(path, error);
    path = fs::canonical(path, error);
    if (is_special) {
      throw FileError(target, kNotRegular);
    }
    if (error) {
      throw FileError(target, "cannot be written: it is a symbolic link to nowhere");
    }
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!path.has_filename() || fs::is_directory(path, error)) {
    throw FileError(target, "cannot be written: it is a folder");
  }
  if (!fs::is_directory(folder, error)) {
    throw FileError(target, "cannot be written: there is no folder " + folder.string());
  }
  const fs::path real_folder = fs::canonical(folder, error);
  return (error ? folder : real_folder) / path.filename();
}

void checkReplaceable(const std::string& given, const fs::path& target) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(target, error);
  if (!fs::exists(status)) {
    return;
  }
  if (!fs::is_regular_file(status)) {
    throw FileError(given, kNotRegular);
  }
  if (access(target.c_str(), W_OK) != 0) {
    throw FileError(given, "cannot be written: " + errorText(errno));
  }
}

}  // namespace

OutputFiles::~OutputFiles() { discard(); }

void OutputFiles::protect(const std::string& path, const std::string& reason) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (!error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    protected_.push_back({real.string(), reason});
  }
}

std::string OutputFiles::stage(const std::string& target) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const fs::path path = resolve(target);
  checkReplaceable(target, path);
  const auto kept = std::find_if(protected_.begin(), protected_.end(),
                                 [&](const Protected& other) { return other.path == path; });
  if (kept != protected_.end()) {
    throw FileError(target, kept->reason);
  }
  if (std::any_of(staged_.begin(), staged_.end(),
                  [&](const Staged& other) { return other.target == path; })) {
    throw FileError(target, "is named for two outputs at once");
  }
  staged_.reserve(staged_.size() + 1);
  for (int number = 0;; ++number) {
    const fs::path temporary =
        path.parent_path() / (".sbox-" + std::to_string(getpid()) + "-" + std::to_string(number) +
                              pathExtension(target));
    const int file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0) {
      close(file);
      staged_.push_back({temporary.string(), path.string(), target});
      return temporary.string();
    }
    if (errno != EEXIST) {
      throw FileError(target, "cannot be written: " + errorText(errno));
    }
  }
}

void OutputFiles::commit() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const Staged& file : staged_) {
    checkReplaceable(file.given, file.target);
  }
  while (!staged_.empty()) {
    const Staged& file = staged_.front();
    if (std::rename(file.temporary.c_str(), file.target.c_str()) != 0) {
      throw FileError(file.given, "cannot be written: " + errorText(errno));
    }
    staged_.erase(staged_.begin());
  }
}

void OutputFiles::discard() noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const Staged& file : staged_) {
    unlink(file.temporary.c_str());
  }
  staged_.clear();
}

}  // namespace sbox
