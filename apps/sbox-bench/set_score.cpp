// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/set_score.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sbox-bench/judge.h"
#include "sbox/io/load_map.h"
#include "sbox/merge.h"

namespace sbox::bench {

std::vector<MapSet> readSets(const PairFolder& folder) {
  MapSet all{"all", {}};
  std::map<std::string, bool> known;
  for (const AnnotatedPair& pair : folder.pairs) {
    for (const std::string& name : {pair.a, pair.b}) {
      if (known.emplace(name, true).second) {
        all.maps.push_back(name);
      }
    }
  }
  std::vector<MapSet> sets{all};
  const std::string path = (std::filesystem::path(folder.path) / "sets.json").string();
  std::ifstream file(path);
  if (!file) {
    return sets;
  }
  try {
    const nlohmann::json listed = nlohmann::json::parse(file);
    for (const nlohmann::json& entry : listed.at("sets")) {
      MapSet set{entry.at("name").get<std::string>(), {}};
      for (const nlohmann::json& map : entry.at("maps")) {
        set.maps.push_back(map.at("map").get<std::string>());
      }
      sets.push_back(set);
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  return sets;
}

SetScore scoreSet(const PairFolder& folder, const MapSet& set, int threads) {
  std::vector<Map> maps;
  std::map<std::string, size_t> index;
  for (const std::string& name : set.maps) {
    index[name] = maps.size();
    maps.push_back(loadMap(findMapFile(folder.path, name), {folder.resolution}));
  }
  MergeOptions options;
  options.threads = threads;
  const MergeResult result = mergeMaps(maps, options);
  SetScore score;
  score.maps = maps.size();
  score.seconds = result.seconds.total;
  for (const MapOutcome& map : result.maps) {
    score.groups = std::max(score.groups, static_cast<size_t>(map.placement.group) + 1);
  }
  for (const AnnotatedPair& pair : folder.pairs) {
    const auto a = index.find(pair.a), b = index.find(pair.b);
    if (a == index.end() || b == index.end()) {
      continue;
    }
    const MapPlacement& at_a = result.maps[a->second].placement;
    const MapPlacement& at_b = result.maps[b->second].placement;
    const Pose2D corner =
        cornerTransform(inverse(at_a.pose) + at_b.pose, maps[a->second].corner_in_map,
                        maps[b->second].corner_in_map);
    const Outcome outcome =
        judge(pair, at_a.group == at_b.group, poseError(pair, folder.resolution, corner));
    ++score.pairs;
    score.right += outcome == Outcome::Right ? 1 : 0;
    score.wrong += outcome == Outcome::Wrong ? 1 : 0;
    score.apart += outcome == Outcome::Refused ? 1 : 0;
  }
  return score;
}

Table setTable(const std::vector<PairFolder>& folders, int threads) {
  Table table{{"set", "maps", "groups", "pairs", "right", "wrong", "apart", "seconds"}, {}};
  for (const PairFolder& folder : folders) {
    for (const MapSet& set : readSets(folder)) {
      const SetScore score = scoreSet(folder, set, threads);
      table.rows.push_back({folder.name + ": " + set.name, std::to_string(score.maps),
                            std::to_string(score.groups), std::to_string(score.pairs),
                            std::to_string(score.right), std::to_string(score.wrong),
                            std::to_string(score.apart), formatNumber(score.seconds, 2)});
    }
  }
  return table;
}

}  // namespace sbox::bench
