// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "adjustment/drifted_robots.h"
#include "catch.h"
#include "sbox/adjustment/adjust_key_frames.h"

using namespace sbox;
using namespace sbox::test;

TEST_CASE("the key frames of robots that drifted move to where they were", "[adjustment]") {
  const DriftedRobots robots;
  const double before = robots.error(joinKeyFrames(robots.placed()));
  const KeyFrames adjusted = adjustKeyFrames(robots.placed(), 0);
  REQUIRE(adjusted.size() == robots.truth.size());
  CHECK(before > 0.15);
  CHECK(robots.error(adjusted) < 0.02);
  CHECK(adjusted.back().seen == robots.of_b.back().seen);
}

TEST_CASE("the reference's key frames do not move on average", "[adjustment]") {
  const size_t reference = GENERATE(0, 1);
  const DriftedRobots robots;
  const KeyFrames joined = joinKeyFrames(robots.placed());
  const KeyFrames adjusted = adjustKeyFrames(robots.placed(), reference);
  const auto first = static_cast<std::ptrdiff_t>(40 * reference);
  const KeyFrames own(joined.begin() + first, joined.begin() + first + 40);
  const KeyFrames own_adjusted(adjusted.begin() + first, adjusted.begin() + first + 40);
  double x = 0, y = 0, moved = 0;
  Point2D centre;
  for (size_t i = 0; i < own.size(); ++i) {
    const Pose2D before = poseOf(own[i]), after = poseOf(own_adjusted[i]);
    centre += Point2D(after.x, after.y) * (1.0 / 40);
    x += after.x - before.x;
    y += after.y - before.y;
    moved += std::hypot(after.x - before.x, after.y - before.y);
  }
  CHECK(x == Approx(0).margin(1e-6));
  CHECK(y == Approx(0).margin(1e-6));
  CHECK(moved > 1);
  // Nor do they turn: no small turn about their middle brings them nearer to where they were.
  const auto apart = [&](double turn) {
    double squares = 0;
    for (size_t i = 0; i < own.size(); ++i) {
      const Pose2D before = poseOf(own[i]), after = poseOf(own_adjusted[i]);
      const Pose2D middle(centre.x, centre.y, 0);
      const Pose2D turned = middle + Pose2D(0, 0, turn) + inverse(middle) + after;
      squares += std::pow(turned.x - before.x, 2) + std::pow(turned.y - before.y, 2) +
                 std::pow(wrapAngle(turned.phi - before.phi), 2);
    }
    return squares;
  };
  CHECK(apart(0) < apart(1e-3));
  CHECK(apart(0) < apart(-1e-3));
}

TEST_CASE("a map that no scan ties to the reference stays where it was placed", "[adjustment]") {
  const DriftedRobots robots;
  const Pose2D far_away(100, -50, 1);
  const std::vector<PlacedKeyFrames> placed{{&robots.of_a, {}}, {&robots.of_b, far_away}};
  const KeyFrames joined = joinKeyFrames(placed), adjusted = adjustKeyFrames(placed, 0);
  double x = 0, y = 0, moved = 0;
  for (size_t i = robots.of_a.size(); i < joined.size(); ++i) {
    const Pose2D before = poseOf(joined[i]), after = poseOf(adjusted[i]);
    x += after.x - before.x;
    y += after.y - before.y;
    moved += std::hypot(after.x - before.x, after.y - before.y);
  }
  CHECK(x == Approx(0).margin(1e-6));
  CHECK(y == Approx(0).margin(1e-6));
  CHECK(moved > 0.1);
}

TEST_CASE("key frames that fit each other stay", "[adjustment]") {
  const DriftedRobots robots(0, {});
  const KeyFrames joined = joinKeyFrames(robots.placed());
  const KeyFrames adjusted = adjustKeyFrames(robots.placed(), 0);
  for (size_t i = 0; i < joined.size(); ++i) {
    const Pose2D before = poseOf(joined[i]), after = poseOf(adjusted[i]);
    CHECK(std::hypot(after.x - before.x, after.y - before.y) < 0.005);
    CHECK(std::abs(wrapAngle(after.phi - before.phi)) < 0.001);
  }
}

TEST_CASE("the number of threads changes nothing", "[adjustment]") {
  const DriftedRobots robots;
  const KeyFrames one = adjustKeyFrames(robots.placed(), 0, {}, 1);
  const KeyFrames three = adjustKeyFrames(robots.placed(), 0, {}, 3);
  for (size_t i = 0; i < one.size(); ++i) {
    CHECK(poseOf(one[i]).x == poseOf(three[i]).x);
    CHECK(poseOf(one[i]).y == poseOf(three[i]).y);
    CHECK(poseOf(one[i]).phi == poseOf(three[i]).phi);
  }
}

TEST_CASE("what is not there cannot be adjusted", "[adjustment]") {
  const DriftedRobots robots;
  CHECK_THROWS_AS(adjustKeyFrames(robots.placed(), 2), std::invalid_argument);
  CHECK_THROWS_AS(adjustKeyFrames({{&robots.of_a, {}}, {nullptr, {}}}, 0), std::invalid_argument);
  const KeyFrames none;
  CHECK(adjustKeyFrames({{&none, {}}, {&robots.of_b, {}}}, 1).size() == robots.of_b.size());
  CHECK(adjustKeyFrames({{&none, {}}, {&robots.of_b, {}}}, 0).size() == robots.of_b.size());
}
