// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox-dataset/fleet.h"
#include "sbox-dataset/write_dataset.h"

using namespace sbox::dataset;

TEST_CASE("a fleet's robots of one building see common places, others never do", "[fleet]") {
  FleetOptions options;
  options.buildings = 2;
  options.robots = 2;
  const std::vector<NamedRun> fleet = driveFleet(options);
  REQUIRE(fleet.size() == 4);
  CHECK(fleet[0].name == "b0r0");
  CHECK(fleet[3].name == "b1r1");
  CHECK(fleet[0].place == fleet[1].place);
  CHECK(fleet[1].place != fleet[2].place);

  const ScratchFolder folder;
  writeDataset(folder.path(""), fleet);
  int common = 0, negative = 0;
  const auto document = nlohmann::json::parse(std::ifstream(folder.path("pairs.json")));
  for (const auto& pair : document.at("pairs")) {
    const bool is_one_building =
        pair.at("a").get<std::string>()[1] == pair.at("b").get<std::string>()[1];
    CHECK(is_one_building != pair.value("negative", false));
    ++(is_one_building ? common : negative);
  }
  CHECK(negative == 4);
  CHECK(common >= 1);
}

TEST_CASE("a fleet's seed decides all, and its drift how far odometry is off", "[fleet]") {
  FleetOptions options;
  options.buildings = 1;
  options.robots = 1;
  const auto offBy = [](const Run& run) {
    const sbox::Pose2D start = run.front().pose_in_world + sbox::inverse(run.front().pose_in_map);
    const sbox::Pose2D end = run.back().pose_in_world + sbox::inverse(run.back().pose_in_map);
    return std::hypot(end.x - start.x, end.y - start.y);
  };
  const Run first = driveFleet(options)[0].steps, again = driveFleet(options)[0].steps;
  REQUIRE(first.size() == again.size());
  CHECK(first.back().pose_in_map.x == again.back().pose_in_map.x);
  options.drift = 0;
  CHECK(offBy(driveFleet(options)[0].steps) < 1e-6);
  CHECK(offBy(first) > 1e-3);
  options.seed = 2;
  CHECK(driveFleet(options)[0].steps.size() != first.size());
}
