// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A merged map as ROS opens it is the same map.
#include "apps/command.h"
#include "apps/office.h"
#include "apps/ros_reader.h"
#include "catch.h"
#include "sbox/io/load_map.h"
#include "sbox/io/save_map.h"

using namespace sbox;
using namespace sbox::test;

namespace {

void checkSameMap(const OccupancyGrid& seen, const Map& map) {
  REQUIRE(seen.width == map.width());
  REQUIRE(seen.height == map.height());
  CHECK(seen.resolution == Approx(map.resolution()).epsilon(1e-6));
  int different = 0, known = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const double p_free = map.grid.getCell(x, y);
      const int expected = p_free >= 0.6 ? 0 : p_free < 0.4 ? 100 : -1;
      const int is = seen.data[static_cast<size_t>(y) * static_cast<size_t>(map.width()) +
                               static_cast<size_t>(x)];
      different += is != expected ? 1 : 0;
      known += is >= 0 ? 1 : 0;
    }
  }
  CHECK(different == 0);
  CHECK(known > 0);
}

}  // namespace

TEST_CASE("ROS opens a merged map as the map that was merged") {
  const RosReader reader = GENERATE(RosReader::Ros1, RosReader::Nav2);
  const ScratchFolder folder;
  const Map floor = office("floor", 1);
  saveMap(cutColumns(floor, "a", 0, 400, {-1.0123, 2.0456, 0}), (folder / "a.gridmap").string());
  saveMap(cutColumns(floor, "b", 60, 480, {3, -4.5, 0.7}), (folder / "b.yaml").string());
  for (const char* name : {"m.gridmap", "m.yaml"}) {
    REQUIRE(runMerge(folder.path(), {"--in", "a.gridmap", "b.yaml", "--out", name}).exit_code == 0);
  }
  const Map merged = loadMap((folder / "m.gridmap").string());
  const OccupancyGrid seen = readAsRos(folder / "m.yaml", reader);
  checkSameMap(seen, merged);
  CHECK(seen.x == Approx(merged.corner_in_map.x).margin(1e-6));
  CHECK(seen.y == Approx(merged.corner_in_map.y).margin(1e-6));
  CHECK(seen.yaw == 0);
}

TEST_CASE("ROS opens any map that was written, with all values, off-grid and turned") {
  const RosReader reader = GENERATE(RosReader::Ros1, RosReader::Nav2);
  const ScratchFolder folder;
  Map map = makeMap("all", 16, 16, 0.03, {-51.224998, 1e-7, -2.5});
  for (int value = -128; value < 128; ++value) {
    map.grid.getRow((value + 128) / 16)[(value + 128) % 16] =
        static_cast<mrpt::maps::COccupancyGridMap2D::cellType>(value);
  }
  saveMap(map, (folder / "all.yaml").string());
  const OccupancyGrid seen = readAsRos(folder / "all.yaml", reader);
  checkSameMap(seen, map);
  CHECK(seen.x == map.corner_in_map.x);
  CHECK(seen.y == map.corner_in_map.y);
  CHECK(seen.yaw == map.corner_in_map.phi);
}
