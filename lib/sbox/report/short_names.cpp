// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/short_names.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>

#include "sbox/core/lower_case.h"
#include "sbox/io/image_file.h"
#include "sbox/io/path_extension.h"

namespace sbox {
namespace {

constexpr size_t most_characters = 60;

std::string safe(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return c >= 0x80 || (std::isalnum(c) == 0 && c != '-' && c != '_'); },
      '_');
  return name.empty() ? "map" : name.substr(0, most_characters);
}

std::string stemOf(const std::string& path) {
  const size_t slash = path.find_last_of('/');
  std::string stem = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::string extension = pathExtension(stem);
  const bool is_map = isImagePath(stem) || isYamlPath(stem) || extension == ".gridmap" ||
                      extension == ".gridmap.gz" || extension == ".simplemap" ||
                      extension == ".simplemap.gz" || extension == ".rawlog" ||
                      extension == ".rawlog.gz";
  if (is_map && stem.size() > extension.size()) {
    stem.resize(stem.size() - extension.size());
  }
  return stem;
}

/// "FOLDER_STEM", or the stem where the path names no folder.
std::string stemWithFolder(const std::string& path) {
  const std::filesystem::path folder =
      std::filesystem::path(path).lexically_normal().parent_path().filename();
  return folder.empty() || folder == ".." ? stemOf(path) : folder.string() + "_" + stemOf(path);
}

}  // namespace

std::vector<std::string> distinctNames(const std::vector<std::string>& names) {
  std::vector<std::string> distinct;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    std::string candidate = name;
    for (int number = 2; !taken.insert(lowerCase(candidate)).second; ++number) {
      candidate = name + "-" + std::to_string(number);
    }
    distinct.push_back(candidate);
  }
  return distinct;
}

std::vector<std::string> shortNames(const std::vector<std::string>& paths) {
  std::map<std::string, int> count_of_stem;
  for (const std::string& path : paths) {
    ++count_of_stem[lowerCase(safe(stemOf(path)))];
  }
  // Robots often call their maps alike, each in its folder.
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    const std::string stem = safe(stemOf(path));
    names.push_back(count_of_stem[lowerCase(stem)] > 1 ? safe(stemWithFolder(path)) : stem);
  }
  return distinctNames(names);
}

std::vector<std::string> shortNames(const MergeResult& result) {
  std::vector<std::string> paths;
  std::transform(result.maps.begin(), result.maps.end(), std::back_inserter(paths),
                 [](const MapOutcome& map) { return map.name; });
  return shortNames(paths);
}

}  // namespace sbox
