// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/paper/transform.h"

using namespace sbox;

TEST_CASE("a transform composes points as its pose does", "[paper]") {
  const Pose2D pose(3, -4, 2.2);
  const Point2D expected = pose.composePoint({1, 7}), moved = Transform(pose)({1, 7});
  CHECK(moved.x == Approx(expected.x));
  CHECK(moved.y == Approx(expected.y));
}
