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

TEST_CASE("the rigid fit finds the pose behind exact points", "[paper]") {
  const std::vector<Point2D> from = {{0, 0}, {4, 0}, {4, 3}, {-7, 12}};
  for (const Pose2D& pose :
       {Pose2D(0, 0, 0), Pose2D(5, -3, 0), Pose2D(0, 0, 2.8), Pose2D(-100, 40, -1.9)}) {
    std::vector<Point2D> to;
    for (const Point2D& p : from) {
      to.push_back(pose.composePoint(p));
    }
    const Pose2D fit = fitRigid(from, to);
    CHECK(fit.x == Approx(pose.x).margin(1e-9));
    CHECK(fit.y == Approx(pose.y).margin(1e-9));
    CHECK(wrapAngle(fit.phi - pose.phi) == Approx(0).margin(1e-9));
  }
}

TEST_CASE("no other rigid transform fits noisy points better", "[paper]") {
  const std::vector<Point2D> from = {{0, 0}, {4, 0}, {4, 3}},
                             to = {{1, 1}, {1.2, 5.3}, {-2.1, 4.8}};
  const auto cost = [&](const Pose2D& pose) {
    double sum = 0;
    for (size_t i = 0; i < from.size(); ++i) {
      const Point2D off = pose.composePoint(from[i]) - to[i];
      sum += off.x * off.x + off.y * off.y;
    }
    return sum;
  };
  const Pose2D fit = fitRigid(from, to);
  for (size_t i = 0; i < 3; ++i) {
    for (const double step : {-1e-3, 1e-3}) {
      Pose2D other = fit;
      other[i] += step;
      CHECK(cost(other) > cost(fit));
    }
  }
}

TEST_CASE("points in mirror image do not make a mirror", "[paper]") {
  const std::vector<Point2D> from = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  const std::vector<Point2D> mirrored = {{0, 0}, {-4, 0}, {-4, 3}, {0, 3}};
  const Transform fit(fitRigid(from, mirrored));
  const Point2D x = fit({1, 0}) - fit({0, 0}), y = fit({0, 1}) - fit({0, 0});
  CHECK(x.x * y.y - x.y * y.x == Approx(1));
}

TEST_CASE("a rigid fit needs pairs", "[paper]") {
  CHECK_THROWS_AS(fitRigid({}, {}), std::invalid_argument);
  CHECK_THROWS_AS(fitRigid({{1, 1}}, {}), std::invalid_argument);
}
