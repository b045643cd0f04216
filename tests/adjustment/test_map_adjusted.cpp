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
  const DriftedRobots robots;
  AdjustmentOptions options;
  options.match.noise = 0.001;  // Of all nonsense, what moves key frames most:
  options.step_metres = 10;     // SLAM that says nothing ...
  options.match.least_overlap = 0;
  options.match.most_turn = 3;  // ... and walls laid on those that face another way.
  options.match.gate = options.match.last_gate = 5;
  options.match.kernel = 5;
  const KeyFrames spoilt = adjustKeyFrames(robots.placed(), 0, options);
  REQUIRE(robots.error(spoilt) > robots.error(joinKeyFrames(robots.placed())));
  const AdjustedMap made = mapAdjusted("hall", robots.placed(), 0, {}, options);
  CHECK_FALSE(made.adjusted);
  CHECK(made.agreement == made.joined_agreement);
  CHECK(robots.error(made.key_frames) ==
        Approx(robots.error(joinKeyFrames(robots.placed()))).epsilon(1e-12));
}

TEST_CASE("scans agree with a map as far as its walls are where they saw them", "[adjustment]") {
  const Room room;
  const KeyFrames frames{keyFrame(room, {}, {})};
  const Map map = mapKeyFrames("room", frames);
  CHECK(scanAgreement(frames, map) > 0.95);
  CHECK(scanAgreement({keyFrame(room, {}, {0.3, 0.2, 0})}, map) < 0.2);
  CHECK(scanAgreement({}, map) == 0);
}
