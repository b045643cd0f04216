// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/short_names.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

#include "sbox/core/lower_case.h"

namespace sbox {
namespace {

constexpr size_t most_characters = 60;

std::string safeStem(const std::string& path) {
  const size_t slash = path.find_last_of('/');
  std::string stem = slash == std::string::npos ? path : path.substr(slash + 1);
  for (const char* extension :
       {".gz", ".gridmap", ".yaml", ".yml", ".png", ".pgm", ".simplemap", ".rawlog"}) {
    const std::string end(extension);
    if (stem.size() > end.size() && stem.compare(stem.size() - end.size(), end.size(), end) == 0) {
      stem.resize(stem.size() - end.size());
    }
  }
  std::replace_if(
      stem.begin(), stem.end(),
      [](unsigned char c) { return c >= 0x80 || (std::isalnum(c) == 0 && c != '-' && c != '_'); },
      '_');
  return stem.empty() ? "map" : stem.substr(0, most_characters);
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
  std::vector<std::string> stems;
  std::transform(paths.begin(), paths.end(), std::back_inserter(stems), safeStem);
  return distinctNames(stems);
}

std::vector<std::string> shortNames(const MergeResult& result) {
  std::vector<std::string> paths;
  std::transform(result.maps.begin(), result.maps.end(), std::back_inserter(paths),
                 [](const MapOutcome& map) { return map.name; });
  return shortNames(paths);
}

}  // namespace sbox
