// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The committed datasets are what their recipes and README say.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox-dataset/drive.h"
#include "sbox-dataset/write_dataset.h"
#include "sbox/core/state_grid.h"
#include "sbox/io/load_map.h"

using namespace sbox;
using namespace sbox::dataset;
using nlohmann::json;

namespace {

const std::string datasets = SBOX_DATASETS;

json readPairs(const std::string& folder) {
  return json::parse(std::ifstream(folder + "/pairs.json")).at("pairs");
}

Pose2D readPose(const json& pose) { return {pose.at("x"), pose.at("y"), pose.at("phi")}; }

/// Root mean square distance, in cells, between the places of a pair under the pose it states.
double residual(const json& pair, const Map& a, const Map& b) {
  const Pose2D pose_b_in_a = readPose(pair.at("pose_b_in_a"));
  const auto placeIn = [](const Map& map, const json& place) {
    return map.corner_in_map.composePoint({place.at(0).get<double>() * map.resolution(),
                                           place.at(1).get<double>() * map.resolution()});
  };
  double sum = 0;
  for (size_t i = 0; i < pair.at("pa").size(); ++i) {
    const Point2D in_a = placeIn(a, pair["pa"][i]);
    sum += (pose_b_in_a.composePoint(placeIn(b, pair["pb"].at(i))) - in_a).sqrNorm();
  }
  return std::sqrt(sum / static_cast<double>(pair.at("pa").size())) / a.resolution();
}

/// Share of b's occupied cells that lie within two cells of one of a's, of those that a knows.
double wallAgreement(const Map& map_a, const Map& map_b, const Pose2D& pose_b_in_a) {
  const StateGrid a = classifyCells(map_a), b = classifyCells(map_b);
  const Pose2D b_in_grid_a = inverse(a.corner_in_map) + pose_b_in_a + b.corner_in_map;
  int agreeing = 0, known = 0;
  for (int y = 0; y < b.height; ++y) {
    for (int x = 0; x < b.width; ++x) {
      const Point2D p =
          b_in_grid_a.composePoint({(x + 0.5) * b.resolution, (y + 0.5) * b.resolution});
      const int ax = static_cast<int>(p.x / a.resolution),
                ay = static_cast<int>(p.y / a.resolution);
      if (b.at(x, y) != CellState::Occupied || a.at(ax, ay) == CellState::Unknown) {
        continue;
      }
      ++known;
      bool near = false;
      for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
          near = near || a.at(ax + dx, ay + dy) == CellState::Occupied;
        }
      }
      agreeing += near ? 1 : 0;
    }
  }
  return static_cast<double>(agreeing) / known;
}

}  // namespace

TEST_CASE("the truth of each committed pair lays walls on walls", "[datasets]") {
  for (const std::string name : {"office", "sena"}) {
    const std::string folder = datasets + "/" + name + "/";
    for (const json& pair : readPairs(folder)) {
      const Map a = loadMap(folder + pair.at("a").get<std::string>() + ".gridmap.gz");
      const Map b = loadMap(folder + pair.at("b").get<std::string>() + ".gridmap.gz");
      INFO(a.name << " and " << b.name);
      CHECK(residual(pair, a, b) == Approx(pair.at("rms_cells").get<double>()).margin(1e-3));
      CHECK(wallAgreement(a, b, readPose(pair.at("pose_b_in_a"))) > 0.8);
    }
  }
}

TEST_CASE("the office is what the simulator makes of it", "[datasets]") {
  const std::string folder = datasets + "/office/";
  const World world = loadWorld(folder + "office.world");
  std::vector<NamedRun> runs;
  for (const std::string name : {"robot_a", "robot_b"}) {
    DriveOptions options;
    options.seed = 1 + static_cast<std::uint32_t>(runs.size());
    runs.push_back({name, "office", drive(world, loadPath(folder + name + ".path"), options)});
  }
  const ScratchFolder scratch;
  const std::string made = scratch.path("new/office/");
  writeDataset(made, runs);
  const json pair = readPairs(made).at(0), committed = readPairs(folder).at(0);
  const Pose2D pose = readPose(pair.at("pose_b_in_a"));
  const Pose2D expected = readPose(committed.at("pose_b_in_a"));
  CHECK(pose.x == Approx(expected.x).margin(0.01));
  CHECK(pose.y == Approx(expected.y).margin(0.01));
  CHECK(pose.phi == Approx(expected.phi).margin(0.001));
  const Map map = loadMap(made + "robot_a.gridmap.gz");
  CHECK(map.width() == loadMap(folder + "robot_a.gridmap.gz").width());
  CHECK_THROWS_AS(writeDataset(made + "pairs.json", runs), std::runtime_error);
}
