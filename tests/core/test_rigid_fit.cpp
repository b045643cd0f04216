// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>
#include <stdexcept>

#include "catch.h"
#include "sbox/core/rigid_fit.h"

using namespace sbox;

TEST_CASE("the rigid fit finds the pose behind exact points", "[core]") {
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

TEST_CASE("no neighbour of the rigid fit is nearer to noisy points", "[core]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-20, 20);
  std::normal_distribution<double> noise(0, 0.3);
  for (const size_t count : {2, 3, 12, 100}) {
    const Pose2D truth(place(random), place(random), place(random));
    std::vector<Point2D> from, to;
    for (size_t i = 0; i < count; ++i) {
      from.emplace_back(place(random), place(random));
      to.push_back(truth.composePoint(from.back()) + Point2D(noise(random), noise(random)));
    }
    const auto squares = [&](const Pose2D& pose) {
      double sum = 0;
      for (size_t i = 0; i < count; ++i) {
        sum += (pose.composePoint(from[i]) - to[i]).sqrNorm();
      }
      return sum;
    };
    const Pose2D fit = fitRigid(from, to);
    for (const double dx : {-1e-3, 0.0, 1e-3}) {
      for (const double dy : {-1e-3, 0.0, 1e-3}) {
        for (const double turn : {-1e-3, 0.0, 1e-3}) {
          if (dx != 0 || dy != 0 || turn != 0) {
            CHECK(squares({fit.x + dx, fit.y + dy, fit.phi + turn}) > squares(fit));
          }
        }
      }
    }
  }
}

TEST_CASE("points in mirror image do not make a mirror", "[core]") {
  const std::vector<Point2D> from = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  const std::vector<Point2D> mirrored = {{0, 0}, {-4, 0}, {-4, 3}, {0, 3}};
  // A half turn brings the longer sides back, at the cost of the shorter ones.
  const Pose2D fit = fitRigid(from, mirrored);
  CHECK(std::abs(wrapAngle(fit.phi)) == Approx(M_PI));
  const Point2D centre = fit.composePoint({2, 1.5});
  CHECK(centre.x == Approx(-2));
  CHECK(centre.y == Approx(1.5));
}

TEST_CASE("of one point a rigid fit is the shift", "[core]") {
  const Pose2D fit = fitRigid({{1, 2}}, {{4, -2}});
  CHECK(fit.x == Approx(3));
  CHECK(fit.y == Approx(-4));
  CHECK(fit.phi == 0);
}

TEST_CASE("a rigid fit needs pairs", "[core]") {
  CHECK_THROWS_AS(fitRigid({}, {}), std::invalid_argument);
  CHECK_THROWS_AS(fitRigid({{1, 1}}, {}), std::invalid_argument);
  CHECK_THROWS_AS(fitRigid({{1, 1}}, {{1, 1}, {2, 2}}), std::invalid_argument);
}
