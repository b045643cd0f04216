// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "mapping/scanned_room.h"
#include "sbox/adjustment/match_scans.h"

using namespace sbox;
using namespace sbox::test;

namespace {

std::vector<ScanPoint> seenFrom(const Room& room, const Pose2D& robot, double max_range = 15) {
  ScanPointOptions options;
  options.max_range = max_range;
  return scanPoints(*keyFrame(room, robot, robot).seen, options);
}

double apart(const Pose2D& a, const Pose2D& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

TEST_CASE("two scans of a room are laid on each other", "[adjustment]") {
  const Room room;
  const Pose2D robot_a(0, 0, 0.2), robot_b(1, 0.7, 2);
  const Pose2D truth = inverse(robot_a) + robot_b;
  const Pose2D start =
      truth + GENERATE(Pose2D(0, 0, 0), Pose2D(0.2, -0.1, 0.06), Pose2D(-0.15, -0.2, -0.06));
  const auto match = matchScans(seenFrom(room, robot_a), seenFrom(room, robot_b), start);
  REQUIRE(match);
  CHECK(apart(match->pose_b_in_a, truth) < 0.01);
  CHECK(std::abs(wrapAngle(match->pose_b_in_a.phi - truth.phi)) < 0.003);
  CHECK(match->overlap > 0.7);
  CHECK(std::sqrt(match->covariance(0, 0)) < 0.05);
  CHECK(std::sqrt(match->covariance(1, 1)) < 0.05);
}

TEST_CASE("down a corridor the start decides, and the covariance says so", "[adjustment]") {
  const Room corridor{-30, 30, -1, 1};
  const Pose2D truth(1, 0, 0), start(1.2, 0.15, 0.03);
  const auto match = matchScans(seenFrom(corridor, {}, 5), seenFrom(corridor, truth, 5), start);
  REQUIRE(match);
  CHECK(match->pose_b_in_a.x == Approx(start.x).margin(0.03));
  CHECK(match->pose_b_in_a.y == Approx(0).margin(0.01));
  CHECK(match->pose_b_in_a.phi == Approx(0).margin(0.003));
  CHECK(std::sqrt(match->covariance(0, 0)) > 0.5);
  CHECK(std::sqrt(match->covariance(1, 1)) < 0.05);
}

TEST_CASE("scans that do not fit have no match", "[adjustment]") {
  const Room room, elsewhere{-1.2, 1.3, -4, 3.5};
  const std::vector<ScanPoint> a = seenFrom(room, {});
  CHECK_FALSE(matchScans(a, seenFrom(elsewhere, {}), {}));
  CHECK_FALSE(matchScans(a, a, {1, 1, 0}));
  CHECK_FALSE(matchScans(a, {}, {}));
  CHECK_FALSE(matchScans({}, a, {}));
  ScanMatchOptions strict;
  strict.most_shift = 0.05;
  CHECK_FALSE(matchScans(a, a, {0.2, 0, 0}, strict));
  CHECK(matchScans(a, a, {0.2, 0, 0}));
}
