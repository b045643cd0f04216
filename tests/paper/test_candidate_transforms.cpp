// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "paper/box_worlds.h"
#include "sbox/paper/agreement.h"
#include "sbox/paper/candidate_transforms.h"

using namespace sbox;

TEST_CASE("one of the four transforms is the true one", "[paper]") {
  const SuppositionalBox box = describeBox({{{1, 2}, {6, 2}, {6, 5}, {1, 5}}});
  for (const Pose2D& pose : {Pose2D(0, 0, 0), Pose2D(7, -3, 0), Pose2D(0, 0, 1.1),
                             Pose2D(-20, 4, -2.6), Pose2D(3, 3, M_PI)}) {
    const SuppositionalBox other = test::moved({box}, pose, 0, 1)[0];
    int right = 0, fitting = 0;
    for (const Pose2D& transform : candidateTransforms(box, other)) {
      right += std::abs(wrapAngle(transform.phi - pose.phi)) < 1e-9 &&
               std::hypot(transform.x - pose.x, transform.y - pose.y) < 1e-9;
      fitting += largestCornerDistance(box, other, transform) < 1e-9;
    }
    CHECK(right == 1);
    CHECK(fitting == 2);  // A rectangle also fits upside down.
  }
}

TEST_CASE("a square fits four ways", "[paper]") {
  const SuppositionalBox box = describeBox({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}});
  const SuppositionalBox other = test::moved({box}, {2, 5, 0.4}, 0, 1)[0];
  for (const Pose2D& transform : candidateTransforms(box, other)) {
    CHECK(largestCornerDistance(box, other, transform) == Approx(0).margin(1e-9));
  }
}

TEST_CASE("shift k lays corners 1, 2, 3 on corners 1 + k, 2 + k, 3 + k", "[paper]") {
  const SuppositionalBox box = describeBox({{{0, 0}, {5, 0}, {5, 2}, {0, 2}}});
  const auto transforms = candidateTransforms(box, box);
  CHECK(wrapAngle(transforms[0].phi) == Approx(0).margin(1e-9));
  CHECK(std::abs(wrapAngle(transforms[2].phi)) == Approx(M_PI));
  // Sides of unequal length do not fit: the least squares of the three corners, by hand, give a
  // dot product of -7 and a cross product of 40 / 3.
  CHECK(transforms[1].phi == Approx(std::atan2(40.0 / 3, -7)));
  const SuppositionalBox square = describeBox({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}});
  CHECK(candidateTransforms(square, square)[1].phi == Approx(M_PI / 2));
  CHECK(candidateTransforms(square, square)[3].phi == Approx(-M_PI / 2));
}
