// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps as ROS users published them. Sizes, poses and counts were found with a few lines of numpy
// from the images and ROS's formula, not with this library.
#include <filesystem>
#include <string>
#include <vector>

#include "catch.h"
#include "sbox/core/state_grid.h"
#include "sbox/io/load_map.h"

using namespace sbox;

namespace {

struct Published {
  const char* name;
  int width;
  int height;
  float resolution;
  Pose2D origin;
  int occupied;
  int free;
  double mean_column;  ///< Of the occupied cells.
  double mean_row;     ///< Counted from the bottom.
};

const std::vector<Published> published_maps = {
    {"backyard", 458, 341, 0.05F, {-8.0, -10.5, 0.0}, 6045, 65661, 244.284, 175.271},
    {"basement_fixed", 1300, 1300, 0.0504F, {25.9, 48.5, 3.14}, 14374, 275742, 716.824, 647.008},
    {"eindhoven", 384, 864, 0.025F, {-5.0, -17.0, 0.0}, 3005, 59369, 193.953, 640.135},
    {"intel", 579, 581, 0.05F, {0.0, 0.0, 0.0}, 29942, 192948, 262.051, 282.994},
    {"jdzx2", 1416, 1102, 0.05F, {-64.801897, -2.095757, 0.0}, 6864, 267376, 835.626, 431.716},
    {"refills_lab", 992, 992, 0.02F, {-8.24, -8.32, 0.0}, 6367, 141289, 484.1, 374.354},
    {"upstairs", 296, 252, 0.05F, {-10.4, -2.57, 0.0}, 2814, 15613, 111.173, 98.39},
    {"yujin_rnd_hokuyo",
     732,
     389,
     0.05F,
     {-3.5999999999999943, -3.1999999999999957, 0.0},
     6895,
     60955,
     358.038,
     156.638},
};

}  // namespace

TEST_CASE("published ROS maps load right", "[published_maps]") {
  const std::filesystem::path folder = std::filesystem::path(SBOX_TEST_DATA) / "yaml";
  if (!std::filesystem::is_directory(folder)) {
    WARN("skipped: there is no folder " << folder);
    return;
  }
  const Published expected = GENERATE(from_range(published_maps));
  const Map map = loadMap((folder / (std::string(expected.name) + ".yaml")).string());
  INFO(expected.name);
  CHECK(map.width() == expected.width);
  CHECK(map.height() == expected.height);
  CHECK(map.grid.getResolution() == expected.resolution);
  CHECK(map.corner_in_map.x == expected.origin.x);
  CHECK(map.corner_in_map.y == expected.origin.y);
  CHECK(map.corner_in_map.phi == expected.origin.phi);
  const StateOptions states;
  int occupied = 0, free = 0;
  double columns = 0, rows = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const float p_free = map.grid.getCell(x, y);
      free += p_free >= states.free_above ? 1 : 0;
      if (p_free < states.occupied_below) {
        ++occupied;
        columns += x;
        rows += y;
      }
    }
  }
  CHECK(occupied == expected.occupied);
  CHECK(free == expected.free);
  CHECK(columns / occupied == Approx(expected.mean_column).margin(0.001));
  CHECK(rows / occupied == Approx(expected.mean_row).margin(0.001));
}
