// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/output_names.h"

#include <algorithm>
#include <filesystem>

#include "sbox-merge/load_inputs.h"
#include "sbox/io/path_extension.h"

namespace sbox::app {
namespace fs = std::filesystem;
namespace {

std::string stem(const std::string& path) {
  return path.substr(0, path.size() - pathExtension(path).size());
}

/// One spelling of a path, whether or not it exists.
fs::path spelling(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::absolute(path), error);
  return error ? path : real;
}

}  // namespace

std::vector<std::string> mergedFileNames(const MergeResult& result, const std::string& output) {
  std::vector<std::string> names;
  for (const MergedGroup& merged : result.merged) {
    names.push_back(names.empty() ? output
                                  : stem(output) + "_group" + std::to_string(merged.group) +
                                        output.substr(stem(output).size()));
  }
  return names;
}

std::string pictureBeside(const std::string& map_file) { return stem(map_file) + ".png"; }

std::vector<std::string> slamMapStems(const std::vector<std::string>& inputs,
                                      const std::string& output) {
  std::vector<std::string> stems;
  for (const std::string& input : inputs) {
    stems.emplace_back();
    if (!isRawlog(input)) {
      continue;
    }
    const std::string wanted = stem(output) + "_" + stem(fs::path(input).filename().string());
    std::string free = wanted;
    for (int number = 2; std::count(stems.begin(), stems.end(), free) > 0; ++number) {
      free = wanted + "_" + std::to_string(number);
    }
    stems.back() = free;
  }
  return stems;
}

std::string pictureInFolder(const std::string& folder, const std::string& file_name,
                            const std::vector<std::string>& map_files) {
  const fs::path path = fs::path(folder) / file_name;
  const bool taken = std::any_of(map_files.begin(), map_files.end(), [&](const std::string& map) {
    return spelling(pictureBeside(map)) == spelling(path);
  });
  return taken ? stem(path.string()) + "_view.png" : path.string();
}

}  // namespace sbox::app
