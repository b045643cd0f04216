// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/refinement/corner_pairs.h"

using namespace sbox;
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

std::array<Vector2d, 4> rectangle(const Vector2d& low, double width, double height,
                                  double angle = 0) {
  std::array<Vector2d, 4> corners{low, low + Vector2d(width, 0), low + Vector2d(width, height),
                                  low + Vector2d(0, height)};
  for (Vector2d& corner : corners) {
    corner = Eigen::Rotation2Dd(angle) * corner;
  }
  return corners;
}

BoxMatch match(const std::array<Vector2d, 4>& a, const std::array<Vector2d, 4>& b) {
  BoxMatch made;
  made.corners_a = a;
  made.corners_b = b;
  return made;
}

}  // namespace

TEST_CASE("half the difference of the sides is the error along each axis", "[refinement]") {
  // Sides of 4 m and 3 m in a, of 3.6 m and 3.2 m in b: eq. 12 says 0.2 m and 0.1 m.
  const auto pairs =
      uniqueCorners({match(rectangle({1, 1}, 4, 3), rectangle({7, 5}, 3.6, 3.2))}, 0.05);
  REQUIRE(pairs.size() == 4);
  CHECK((pairs[0].in_a - Vector2d(1, 1)).norm() < 1e-12);
  CHECK((pairs[0].in_b - Vector2d(7, 5)).norm() < 1e-12);
  CHECK((pairs[2].in_a - Vector2d(5, 4)).norm() < 1e-12);
  CHECK((pairs[2].in_b - Vector2d(10.6, 8.2)).norm() < 1e-12);
  const Matrix2d expected = Vector2d(0.04 + 0.0025, 0.01 + 0.0025).asDiagonal();
  for (const CornerPair& pair : pairs) {
    CHECK((pair.covariance - expected).norm() < 1e-12);
  }
}

TEST_CASE("the error lies along the box's own axes in map a", "[refinement]") {
  const double in_a = 0.7;
  const auto pairs =
      uniqueCorners({match(rectangle({1, 1}, 4, 3, in_a), rectangle({7, 5}, 3, 3, -1.1))}, 0.1);
  REQUIRE(pairs.size() == 4);
  const Matrix2d turn = Eigen::Rotation2Dd(in_a).toRotationMatrix();
  const Matrix2d expected = turn * Vector2d(0.25 + 0.01, 0.01).asDiagonal() * turn.transpose();
  CHECK((pairs[0].covariance - expected).norm() < 1e-9);
}

TEST_CASE("a corner that several boxes share is counted once, with their mean error",
          "[refinement]") {
  // Two rooms side by side share two corners; the second's width differs by 0.4 m.
  const auto pairs = uniqueCorners({match(rectangle({0, 0}, 4, 3), rectangle({0, 0}, 4, 3)),
                                    match(rectangle({4, 0}, 5, 3), rectangle({4, 0}, 5.4, 3)),
                                    match(rectangle({0, 0}, 4, 3), rectangle({0, 0}, 4, 3))},
                                   0.1);
  REQUIRE(pairs.size() == 6);
  int shared = 0;
  for (const CornerPair& pair : pairs) {
    const double along_x = pair.covariance(0, 0) - 0.01;
    if (pair.in_a.x() == Approx(4)) {
      ++shared;
      // Two boxes without an error and one of 0.2 m.
      CHECK(along_x == Approx(0.04 / 3));
    } else {
      CHECK(along_x == Approx(pair.in_a.x() > 4 ? 0.04 : 0).margin(1e-12));
    }
    CHECK(pair.covariance(1, 1) == Approx(0.01));
  }
  CHECK(shared == 2);
}

TEST_CASE("one corner of a on two of b makes two pairs; no boxes make none", "[refinement]") {
  CHECK(uniqueCorners({}, 0.1).empty());
  CHECK(uniqueCorners({match(rectangle({0, 0}, 4, 3), rectangle({0, 0}, 4, 3)),
                       match(rectangle({0, 0}, 4, 3), rectangle({0.3, 0}, 4, 3))},
                      0.1)
            .size() == 8);
}
