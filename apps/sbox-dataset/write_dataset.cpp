// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/write_dataset.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sbox-bench/text_file.h"
#include "sbox-dataset/output_folder.h"
#include "sbox-dataset/truth.h"
#include "sbox/io/save_map.h"

namespace sbox::dataset {
namespace {

using nlohmann::ordered_json;

ordered_json pairEntry(const std::string& environment, const PairTruth& truth, const Map& map_a,
                       const Map& map_b) {
  // The file counts cells from each map's lower-left corner, and turns a into b.
  const Pose2D corner_a_in_corner_b =
      inverse(map_b.corner_in_map) + inverse(truth.pose_b_in_a) + map_a.corner_in_map;
  const double cell = map_a.resolution();
  ordered_json pair = {{"env", environment},
                       {"a", map_a.name},
                       {"b", map_b.name},
                       {"n", truth.places.size()},
                       {"theta_deg", wrapAngle(corner_a_in_corner_b.phi) * 180 / M_PI},
                       {"t_cells", {corner_a_in_corner_b.x / cell, corner_a_in_corner_b.y / cell}},
                       {"rms_cells", truth.rms / cell},
                       {"overlap", truth.overlap},
                       {"pose_b_in_a",
                        {{"x", truth.pose_b_in_a.x},
                         {"y", truth.pose_b_in_a.y},
                         {"phi", wrapAngle(truth.pose_b_in_a.phi)}}},
                       {"pa", ordered_json::array()},
                       {"pb", ordered_json::array()}};
  for (const auto& [in_a, in_b] : truth.places) {
    const Point2D a = map_a.corner_in_map.inverseComposePoint(in_a),
                  b = map_b.corner_in_map.inverseComposePoint(in_b);
    pair["pa"].push_back({a.x / cell, a.y / cell});
    pair["pb"].push_back({b.x / cell, b.y / cell});
  }
  return pair;
}

/// Of maps that have nothing in common; with the fields of other pairs.
ordered_json negativeEntry(const Map& map_a, const Map& map_b) {
  return {{"env", "different"},         {"a", map_a.name}, {"b", map_b.name},
          {"negative", true},           {"n", 0},          {"theta_deg", 0},
          {"t_cells", {0, 0}},          {"rms_cells", 0},  {"pa", ordered_json::array()},
          {"pb", ordered_json::array()}};
}

}  // namespace

void writeDataset(const std::string& folder, const std::vector<NamedRun>& runs,
                  const MappingOptions& mapping) {
  makeFolder(folder);
  std::vector<Map> maps;
  for (const NamedRun& run : runs) {
    maps.push_back(mapRun(run.name, run.steps, mapping));
    const std::string stem = (std::filesystem::path(folder) / run.name).string();
    saveMap(maps.back(), stem + ".gridmap.gz");
    saveMap(maps.back(), stem + ".png");
  }
  ordered_json document = {{"resolution", mapping.resolution}, {"pairs", ordered_json::array()}};
  for (size_t a = 0; a < runs.size(); ++a) {
    for (size_t b = a + 1; b < runs.size(); ++b) {
      if (runs[a].place != runs[b].place) {
        document["pairs"].push_back(negativeEntry(maps[a], maps[b]));
        continue;
      }
      const auto truth = findTruth(runs[a].steps, runs[b].steps, maps[a], maps[b]);
      if (truth) {
        document["pairs"].push_back(pairEntry(runs[a].place, *truth, maps[a], maps[b]));
      }
    }
  }
  bench::writeText((std::filesystem::path(folder) / "pairs.json").string(),
                   document.dump(1) + "\n");
}

}  // namespace sbox::dataset
