// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-scale/fleet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>

#include "sbox-dataset/drive.h"
#include "sbox-dataset/office.h"
#include "sbox-dataset/ranger.h"
#include "sbox-dataset/route.h"
#include "sbox-dataset/world_grid.h"
#include "sbox-scale/merge_run.h"
#include "sbox/io/save_map.h"

namespace sbox::scale {
namespace {

constexpr double kCell = 0.05;  ///< Of the simulated worlds and all maps, metres.

/// A way through a run of neighbouring rooms, half to nearly all of them.
dataset::Path randomTour(const dataset::RoutePlanner& planner, std::vector<Point2D> places,
                         std::mt19937& random) {
  std::sort(places.begin(), places.end(), [](const Point2D& left, const Point2D& right) {
    return std::pair(left.x, left.y) < std::pair(right.x, right.y);
  });
  const double share = std::uniform_real_distribution<double>(0.5, 0.9)(random);
  const double from = std::uniform_real_distribution<double>(0, 1 - share)(random);
  const auto count = static_cast<double>(places.size());
  const auto first = places.begin() + static_cast<std::ptrdiff_t>(from * count);
  const auto last = places.begin() + static_cast<std::ptrdiff_t>((from + share) * count);
  std::vector<Point2D> visited(first, last);
  const double heading = std::uniform_real_distribution<double>(-M_PI, M_PI)(random);
  const Pose2D start(visited.front().x, visited.front().y, heading);
  visited.erase(visited.begin());
  return planner.tour(start, visited);
}

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
      const bool is_one_building = fleet[a].building == fleet[b].building;
      if (maps[a]["group"] != maps[b]["group"]) {
        score.apart += is_one_building ? 1 : 0;
        continue;
      }
      const Pose2D off = inverse(inverse(fleet[a].map_in_building) + fleet[b].map_in_building) +
                         (inverse(poseOf(maps[a])) + poseOf(maps[b]));
      const bool is_right = is_one_building && std::hypot(off.x, off.y) <= right_distance &&
                            std::abs(wrapAngle(off.phi)) <= right_turn;
      (is_right ? score.right : score.wrong) += 1;
    }
  }
  return score;
}

}  // namespace

std::vector<FleetMap> makeFleet(int maps, const std::filesystem::path& folder) {
  constexpr int robots = 5;
  std::vector<FleetMap> fleet;
  for (int building = 0; building * robots < maps; ++building) {
    const auto seed = static_cast<std::uint32_t>(building + 1);
    const dataset::World world = dataset::randomOffice(seed);
    const mrpt::maps::COccupancyGridMap2D grid = dataset::worldGrid(world, kCell);
    const dataset::RoutePlanner planner(grid);
    std::mt19937 random(seed);
    for (int robot = 0; robot < robots && static_cast<int>(fleet.size()) < maps; ++robot) {
      dataset::DriveOptions options;
      options.seed = static_cast<std::uint32_t>(random());
      const dataset::Path path = randomTour(planner, world.places, random);
      const std::string file =
          "b" + std::to_string(building) + "r" + std::to_string(robot) + ".gridmap";
      saveMap(mapRun(file, drive(dataset::gridRanger(grid), path, options)), folder / file);
      fleet.push_back({file, building, path.start_in_world});
    }
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
