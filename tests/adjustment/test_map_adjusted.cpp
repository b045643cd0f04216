// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "adjustment/drifted_robots.h"
#include "catch.h"
#include "sbox/adjustment/map_adjusted.h"
#include "sbox/adjustment/scan_agreement.h"

using namespace sbox;
using namespace sbox::test;

TEST_CASE("a map of adjusted key frames holds what the scans saw", "[adjustment]") {
  const DriftedRobots robots;
  const AdjustedMap made = mapAdjusted("hall", robots.placed(), 0);
  CHECK(made.adjusted);
  CHECK(made.joined_agreement < 0.7);
  CHECK(made.agreement > 0.95);
  CHECK(made.agreement == scanAgreement(made.key_frames, made.map));
  CHECK(robots.error(made.key_frames) < 0.02);
}

TEST_CASE("key frames are left as they were where adjusting them made no map sharper",
          "[adjustment]") {
  // Two rooms side by side; what matches far too readily lays one on the other.
  const Room west{-1.26, 1.24, -1.53, 1.51}, east{1.33, 3.42, -1.02, 1.63};
  KeyFrames of_west, of_east;
  for (const double step : {-0.4, 0.0, 0.4}) {
    const Pose2D in_west(0, step, 0.3 * step), in_east(2.4, 0.3 + step, -0.2 * step);
    of_west.push_back(keyFrame(west, in_west, in_west));
    of_east.push_back(keyFrame(east, in_east, in_east));
  }
  const std::vector<PlacedKeyFrames> maps{{&of_west, {}}, {&of_east, {}}};
  AdjustmentOptions options;
  options.match.gate = options.match.last_gate = options.match.kernel = options.match.most_shift =
      3;
  REQUIRE(poseOf(adjustKeyFrames(maps, 0, options).back()).x < 1.5);
  const AdjustedMap made = mapAdjusted("rooms", maps, 0, {}, options);
  CHECK_FALSE(made.adjusted);
  CHECK(made.agreement == made.joined_agreement);
  CHECK(poseOf(made.key_frames.back()).x == Approx(2.4));
}

TEST_CASE("scans agree with a map as far as its walls are where they saw them", "[adjustment]") {
  const Room room;
  const KeyFrames frames{keyFrame(room, {}, {})};
  const Map map = mapKeyFrames("room", frames);
  CHECK(scanAgreement(frames, map) > 0.95);
  CHECK(scanAgreement({keyFrame(room, {}, {0.3, 0.2, 0})}, map) < 0.2);
  CHECK(scanAgreement({}, map) == 0);
}
