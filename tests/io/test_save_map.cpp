// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What comes back after a map was written, for each format.
#include <cmath>

#include "catch.h"
#include "io/scratch_folder.h"
#include "io/test_maps.h"
#include "sbox/io/file_error.h"
#include "sbox/io/load_map.h"
#include "sbox/io/save_map.h"

using namespace sbox;

namespace {

void checkPose(const Pose2D& pose, const Pose2D& expected) {
  CHECK(pose.x == expected.x);
  CHECK(pose.y == expected.y);
  CHECK(pose.phi == expected.phi);
}

}  // namespace

TEST_CASE("an MRPT file keeps every cell bit for bit", "[save_map]") {
  const ScratchFolder folder;
  const std::string path = folder.path(GENERATE("a.gridmap", "a.gridmap.gz", "A.GRIDMAP"));
  const double resolution = GENERATE(0.02, 0.05, 0.25);
  const auto [width, height] = GENERATE(table<int, int>({{1, 1}, {37, 21}, {300, 2}}));
  const Map map = randomMap(width, height, resolution, {-3, 2, 0});
  saveMap(map, path);
  const Map read = loadMap(path);
  CHECK(read.name == path);
  CHECK(read.width() == width);
  CHECK(read.height() == height);
  CHECK(read.grid.getResolution() == map.grid.getResolution());
  CHECK(read.grid.getRawMap() == map.grid.getRawMap());
  checkPose(read.corner_in_map, {-3, 2, 0});
}

TEST_CASE("an MRPT file keeps corners off the grid to float precision", "[save_map]") {
  const ScratchFolder folder;
  // Half a cell off is where MRPT's rounding of the two ends is most at risk to disagree.
  const auto [x, y] = GENERATE(table<double, double>(
      {{-51.224998, 13.0171}, {0.025, -0.025}, {-1.025, 7.325}, {123.475, -987.6125}}));
  const Map map = randomMap(41, 30, 0.05, {x, y, 0});
  saveMap(map, folder.path("a.gridmap"));
  const Map read = loadMap(folder.path("a.gridmap"));
  CHECK(read.corner_in_map.x == static_cast<double>(static_cast<float>(x)));
  CHECK(read.corner_in_map.y == static_cast<double>(static_cast<float>(y)));
  CHECK(read.grid.getRawMap() == map.grid.getRawMap());
}

TEST_CASE("a corner beyond what floats can hold is an error, not a wrong file", "[save_map]") {
  const ScratchFolder folder;
  const Map map = randomMap(41, 30, 0.05, {4.5e6, 1e7, 0});
  CHECK_THROWS_AS(saveMap(map, folder.path("a.gridmap")), FileError);
  CHECK(folder.names().empty());
  saveMap(map, folder.path("a.yaml"));
  checkPose(loadMap(folder.path("a.yaml")).corner_in_map, {4.5e6, 1e7, 0});
}

TEST_CASE("a turned map is written to an MRPT file along the axes", "[save_map]") {
  const ScratchFolder folder;
  const std::vector<std::string> rows = {"#. ",  //
                                         "..."};
  saveMap(drawnMap(rows, 0.5, {10, 20, M_PI / 2}), folder.path("a.gridmap"));
  const Map read = loadMap(folder.path("a.gridmap"));
  CHECK(drawing(read) == std::vector<std::string>{" .", "..", "#."});
  CHECK(read.corner_in_map.x == Approx(9));
  CHECK(read.corner_in_map.y == Approx(20));
  CHECK(read.corner_in_map.phi == 0);
}

TEST_CASE("a ROS file keeps the pose exactly and each cell's state", "[save_map]") {
  const ScratchFolder folder;
  const std::string path = folder.path(GENERATE("a.yaml", "a b: #'c.yml"));
  const Pose2D corner = GENERATE(Pose2D{}, Pose2D{-51.224998, 1.0 / 3, 0},
                                 Pose2D{-8.24, 1e-7, 3.14}, Pose2D{431882.35, -1e9, -0.7});
  const Map map = randomMap(64, 33, 0.0504, corner);
  saveMap(map, path);
  const Map read = loadMap(path);
  checkPose(read.corner_in_map, corner);
  CHECK(read.grid.getResolution() == map.grid.getResolution());
  CHECK(drawing(read) == drawing(map));
}

TEST_CASE("a picture keeps each cell's state", "[save_map]") {
  const ScratchFolder folder;
  const std::string path = folder.path(GENERATE("a.png", "a.pgm"));
  const Map map = randomMap(50, 20, 0.1, {});
  saveMap(map, path);
  const Map read = loadMap(path, {0.1});
  CHECK(drawing(read) == drawing(map));
  CHECK(read.grid.getResolution() == 0.1F);
}

TEST_CASE("writing the same map twice gives the same bytes", "[save_map]") {
  const ScratchFolder folder;
  const Map map = randomMap(50, 20, 0.1, {1, 2, 0});
  for (const std::string extension : {".gridmap", ".yaml", ".pgm", ".png"}) {
    saveMap(map, folder.path("a" + extension));
    const std::string first = folder.read("a" + extension);
    saveMap(map, folder.path("a" + extension));
    CHECK(folder.read("a" + extension) == first);
  }
}

TEST_CASE("a map among other outputs appears with them", "[save_map]") {
  const ScratchFolder folder;
  const Map map = randomMap(5, 5, 0.1, {});
  {
    OutputFiles files;
    saveMap(map, folder.path("a.yaml"), files);
    saveMap(map, folder.path("a.gridmap"), files);
    CHECK_THROWS_AS(loadMap(folder.path("a.yaml")), FileError);
    files.commit();
  }
  CHECK(folder.names() == std::vector<std::string>{"a.gridmap", "a.pgm", "a.yaml"});
  CHECK(drawing(loadMap(folder.path("a.yaml"))) == drawing(map));
}

TEST_CASE("a map is not written under a name of another kind", "[save_map]") {
  const ScratchFolder folder;
  const Map map = randomMap(5, 5, 0.1, {});
  for (const char* name : {"a", "a.txt", "a.gz", "a.jpg", ".gridmap", "a.gridmap.bz2"}) {
    CHECK_THROWS_AS(saveMap(map, folder.path(name)), FileError);
  }
  CHECK(folder.names().empty());
}
