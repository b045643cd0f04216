// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "paper/box_worlds.h"
#include "sbox/paper/best_pair.h"

using namespace sbox;

TEST_CASE("eq. 5 is the smaller area over the sum of distances", "[paper]") {
  const SuppositionalBox small = describeBox({{{0, 0}, {4, 0}, {4, 3}, {0, 3}}});
  const SuppositionalBox large = describeBox({{{0, 0}, {5, 0}, {5, 3}, {0, 3}}});
  Agreement agreement;
  agreement.distance_sum = 0.5;
  CHECK(score(small, large, agreement, 0.05) == Approx(24));
  CHECK(score(large, small, agreement, 0.05) == Approx(24));
  agreement.distance_sum = 0;
  CHECK(score(small, large, agreement, 0.05) == Approx(240));
}

TEST_CASE("the best pair has the true transform", "[paper]") {
  BestPairOptions options;
  options.min_agreeing = 20;
  for (const Pose2D& pose :
       {Pose2D(0, 0, 0), Pose2D(6, -2, 0), Pose2D(0, 0, 2.2), Pose2D(-15, 8, -0.7)}) {
    const auto boxes_a = test::randomBoxes(40, 5);
    const auto best = findBestPair(boxes_a, test::moved(boxes_a, pose, 0.05, 6), options);
    REQUIRE(best);
    CHECK(best->enough);
    CHECK(best->match.a == best->match.b);
    CHECK(std::hypot(best->pose_a_in_b.x - pose.x, best->pose_a_in_b.y - pose.y) < 0.5);
    CHECK(std::abs(wrapAngle(best->pose_a_in_b.phi - pose.phi)) < 0.05);
    CHECK(best->agreement.matches.size() >= 20);
  }
}

TEST_CASE("too little agreement still names the best there is", "[paper]") {
  const auto boxes = test::randomBoxes(6, 5);
  BestPairOptions options;
  options.min_agreeing = 50;
  const auto best = findBestPair(boxes, boxes, options);
  REQUIRE(best);
  CHECK_FALSE(best->enough);
  CHECK(best->agreement.matches.size() == 5);
}

TEST_CASE("boxes of other sizes give no pair", "[paper]") {
  const std::vector<SuppositionalBox> small = {describeBox({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}})};
  const std::vector<SuppositionalBox> large = {describeBox({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}})};
  CHECK_FALSE(findBestPair(small, large));
  CHECK_FALSE(findBestPair({}, large));
}
