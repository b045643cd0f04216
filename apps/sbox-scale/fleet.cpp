// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-scale/fleet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sbox-dataset/fleet.h"
#include "sbox-scale/merge_run.h"
#include "sbox/io/save_map.h"

namespace sbox::scale {
namespace {

/// How the poses of all pairs of maps that the report puts into one group compare with the truth.
struct FleetScore {
  int right = 0;
  int wrong = 0;
  int apart = 0;  ///< Maps of one building in different groups.
};

Pose2D poseOf(const nlohmann::json& map) {
  return {map["pose"]["x"], map["pose"]["y"], map["pose"]["phi"]};
}

FleetScore scoreFleet(const nlohmann::json& report, const std::vector<FleetMap>& fleet) {
  constexpr double right_distance = 0.5, right_turn = 3 * M_PI / 180;
  const nlohmann::json& maps = report["maps"];
  FleetScore score;
  for (size_t a = 0; a < fleet.size(); ++a) {
    for (size_t b = a + 1; b < fleet.size(); ++b) {
      const bool is_one_place = fleet[a].place == fleet[b].place;
      if (maps[a]["group"] != maps[b]["group"]) {
        score.apart += is_one_place ? 1 : 0;
        continue;
      }
      const Pose2D off = inverse(inverse(fleet[a].map_in_place) + fleet[b].map_in_place) +
                         (inverse(poseOf(maps[a])) + poseOf(maps[b]));
      const bool is_right = is_one_place && std::hypot(off.x, off.y) <= right_distance &&
                            std::abs(wrapAngle(off.phi)) <= right_turn;
      (is_right ? score.right : score.wrong) += 1;
    }
  }
  return score;
}

}  // namespace

std::vector<FleetMap> makeFleet(int maps, const std::filesystem::path& folder) {
  dataset::FleetOptions options;
  options.buildings = (maps + options.robots - 1) / options.robots;
  std::vector<FleetMap> fleet;
  for (const dataset::NamedRun& run : dataset::driveFleet(options)) {
    if (static_cast<int>(fleet.size()) == maps) {
      break;
    }
    const std::string file = run.name + ".gridmap";
    saveMap(mapRun(file, run.steps), folder / file);
    const dataset::RunStep& start = run.steps.front();
    fleet.push_back({file, run.place, start.pose_in_world + inverse(start.pose_in_map)});
  }
  return fleet;
}

void printFleetHeader() {
  std::printf("%6s %9s %8s %8s %8s %6s %8s | %6s %6s %6s %6s\n", "maps", "all pairs", "matched",
              "seconds", "features", "MiB", "ms/map^2", "groups", "right", "wrong", "apart");
}

void measureFleet(const std::string& command, const std::vector<FleetMap>& fleet,
                  const std::filesystem::path& folder, const std::vector<std::string>& arguments) {
  std::vector<std::string> files;
  for (const FleetMap& map : fleet) {
    files.push_back(map.file);
  }
  const MergeRun run = runMerge(command, folder, files, arguments);
  if (!run.report.is_object()) {
    std::printf("%6zu  exit code %d after %.2f s\n", fleet.size(), run.exit_code, run.seconds);
    return;
  }
  const FleetScore score = scoreFleet(run.report, fleet);
  int groups = 0;
  for (const nlohmann::json& map : run.report["maps"]) {
    groups = std::max(groups, map["group"].get<int>() + 1);
  }
  const auto count = static_cast<double>(fleet.size());
  std::printf("%6zu %9.0f %8zu %8.2f %8.2f %6.0f %8.3f | %6d %6d %6d %6d\n", fleet.size(),
              count * (count - 1) / 2, run.report["pairs"].size(), run.seconds,
              run.report["seconds"]["features"].get<double>(), run.peak_mib,
              1000 * run.seconds / (count * count), groups, score.right, score.wrong, score.apart);
  std::fflush(stdout);
}

}  // namespace sbox::scale
