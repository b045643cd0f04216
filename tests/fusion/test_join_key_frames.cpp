// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "mapping/scanned_room.h"
#include "sbox/fusion/fuse_maps.h"
#include "sbox/fusion/join_key_frames.h"
#include "sbox/mapping/map_key_frames.h"

using namespace sbox;
using namespace sbox::test;

namespace {

int occupiedCells(const Map& map) {
  int count = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      count += map.grid.getCell(x, y) < 0.4F ? 1 : 0;
    }
  }
  return count;
}

/// Two robots' maps of one room, and where the second lies in the first.
struct TwoMaps {
  Room room;
  Pose2D pose_b_in_a{2, -1, 0.4};
  KeyFrames of_a, of_b, all_in_a;

  TwoMaps() {
    for (const Pose2D& robot : {Pose2D(0, 0, 0), Pose2D(1, 0.5, 1)}) {
      of_a.push_back(keyFrame(room, robot, robot));
      all_in_a.push_back(of_a.back());
    }
    for (const Pose2D& robot : {Pose2D(-1, 0.3, -2), Pose2D(2, 1.2, 3)}) {
      of_b.push_back(keyFrame(room, robot, inverse(pose_b_in_a) + robot));
      all_in_a.push_back(keyFrame(room, robot, robot));
    }
  }
  [[nodiscard]] KeyFrames joined() const {
    return joinKeyFrames({{&of_a, {}}, {&of_b, pose_b_in_a}});
  }
};

}  // namespace

TEST_CASE("key frames are joined in the reference's frame, and what was seen is shared",
          "[join_key_frames]") {
  const TwoMaps maps;
  const KeyFrames joined = maps.joined();
  REQUIRE(joined.size() == 4);
  for (size_t i = 0; i < joined.size(); ++i) {
    const Pose2D pose = poseOf(joined[i]), expected = poseOf(maps.all_in_a[i]);
    CHECK(pose.x == Approx(expected.x));
    CHECK(pose.y == Approx(expected.y).margin(1e-12));
    CHECK(wrapAngle(pose.phi - expected.phi) == Approx(0).margin(1e-12));
  }
  CHECK(joined[2].seen == maps.of_b[0].seen);
  CHECK(poseOf(maps.of_b[0]).x != Approx(-1));  // the map's own are as they were
}

TEST_CASE("a map of joined key frames has thinner walls than joined cells", "[join_key_frames]") {
  const TwoMaps maps;
  const Map a = mapKeyFrames("a", maps.of_a), b = mapKeyFrames("b", maps.of_b);
  const Map by_cells = fuseMaps({{&a, {}}, {&b, maps.pose_b_in_a}}, 0).merged;
  CHECK(occupiedCells(mapKeyFrames("all", maps.joined())) < occupiedCells(by_cells));
}

TEST_CASE("a map that holds no scans cannot be joined by them", "[join_key_frames]") {
  CHECK_THROWS_AS(joinKeyFrames({{nullptr, {}}}), std::invalid_argument);
}
