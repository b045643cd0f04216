// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox-dataset/drive.h"

using namespace sbox;
using namespace sbox::dataset;

namespace {

World squareRoom() {
  World world;
  world.walls = {{{-4, -4}, {4, -4}}, {{4, -4}, {4, 4}}, {{4, 4}, {-4, 4}}, {{-4, 4}, {-4, -4}}};
  return world;
}

}  // namespace

TEST_CASE("a robot ends at the last point of its path", "[drive]") {
  const Path path{{1, 1, 0.5}, {{1, 3}, {-2, 3}}};
  const Run run = drive(squareRoom(), path);
  CHECK(run.front().pose_in_world.phi == 0.5);
  CHECK(run.back().pose_in_world.x == Approx(-2));
  CHECK(run.back().pose_in_world.y == Approx(3));
  CHECK(std::abs(wrapAngle(run.back().pose_in_world.phi - M_PI)) < 1e-9);
}

TEST_CASE("without noise the robot knows where it is and sees exact ranges", "[drive]") {
  DriveOptions options;
  options.range_sigma = options.odometry_sigma = options.heading_sigma = 0;
  const Run run = drive(squareRoom(), {{1, 1, 0.5}, {{1, 3}, {-2, 3}}}, options);
  for (const RunStep& step : run) {
    const Pose2D expected = inverse(run.front().pose_in_world) + step.pose_in_world;
    CHECK(step.pose_in_map.x == Approx(expected.x).margin(1e-9));
    CHECK(step.pose_in_map.y == Approx(expected.y).margin(1e-9));
  }
  const auto& scan = run.back().scan;
  const size_t ahead = scan.getScanSize() / 2;
  CHECK(scan.getScanAngle(ahead) == Approx(0).margin(1e-6));
  CHECK(scan.getScanRange(ahead) == Approx(2));
}

TEST_CASE("what is out of range is not seen", "[drive]") {
  DriveOptions options;
  options.max_range = 1;
  const Run run = drive(squareRoom(), {{0, 0, 0}, {}}, options);
  REQUIRE(run.size() == 1);
  for (size_t i = 0; i < run[0].scan.getScanSize(); ++i) {
    REQUIRE_FALSE(run[0].scan.getScanRangeValidity(i));
  }
}

TEST_CASE("the seed decides the noise", "[drive]") {
  const Path path{{0, 0, 0}, {{2, 0}}};
  DriveOptions options;
  options.seed = 5;
  const Run once = drive(squareRoom(), path, options), again = drive(squareRoom(), path, options);
  options.seed = 6;
  const Run other = drive(squareRoom(), path, options);
  CHECK(once.back().pose_in_map.y == again.back().pose_in_map.y);
  CHECK(once.back().scan.getScanRange(0) == again.back().scan.getScanRange(0));
  CHECK(once.back().pose_in_map.y != other.back().pose_in_map.y);
}

TEST_CASE("a path file starts with a pose", "[drive]") {
  const ScratchFolder scratch;
  const Path path = loadPath(scratch.write("p", "start 1 2 90\nto 3 4\n"));
  CHECK(path.start_in_world.phi == Approx(M_PI / 2));
  REQUIRE(path.points_in_world.size() == 1);
  CHECK(path.points_in_world[0].y == 4);
  CHECK_THROWS_WITH(loadPath(scratch.write("p", "to 3 4\n")),
                    scratch.path("p") + ":1: expected: start x y heading_deg");
  CHECK_THROWS(loadPath(scratch.write("p", "# nothing\n")));
}
