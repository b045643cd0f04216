// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/load_folder.h"

#include <map>
#include <utility>

#include "sbox/core/parallel.h"
#include "sbox/io/load_map.h"

namespace sbox::bench {

LoadedFolder loadFolder(PairFolder folder, const PairChoice& choice, int threads) {
  LoadedFolder loaded;
  std::vector<AnnotatedPair> chosen;
  int seen = 0;
  for (AnnotatedPair& pair : folder.pairs) {
    const std::string text = folder.name + " " + pair.group + " " + pair.a + " " + pair.b;
    if (text.find(choice.only) != std::string::npos && seen++ % choice.every == 0) {
      chosen.push_back(std::move(pair));
    }
  }
  folder.pairs = std::move(chosen);

  std::map<std::string, int> index_of;
  std::vector<std::string> names;
  const auto indexOf = [&](const std::string& name) {
    const auto [place, is_new] = index_of.try_emplace(name, static_cast<int>(names.size()));
    if (is_new) {
      names.push_back(name);
    }
    return place->second;
  };
  for (const AnnotatedPair& pair : folder.pairs) {
    const int a = indexOf(pair.a);
    loaded.map_of_pair.emplace_back(a, indexOf(pair.b));
  }
  loaded.maps.resize(names.size());
  parallelFor(static_cast<int>(names.size()), threads, [&](int i) {
    const auto k = static_cast<size_t>(i);
    loaded.maps[k] = loadMap(findMapFile(folder.path, names[k]));
  });
  loaded.folder = std::move(folder);
  return loaded;
}

}  // namespace sbox::bench
