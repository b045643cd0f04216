// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox-bench/methods/hough_spectrum.h"

using namespace sbox;
using namespace sbox::bench;

namespace {

/// A rectangle's outline of 8 m by 4 m, turned by `angle`.
std::vector<Point2D> outline(double angle) {
  const Pose2D turn(0, 0, angle);
  std::vector<Point2D> points;
  for (double along = 0; along < 8; along += 0.1) {
    points.push_back(turn.composePoint({along, 0.0}));
    points.push_back(turn.composePoint({along, 4.0}));
  }
  for (double along = 0; along < 4; along += 0.1) {
    points.push_back(turn.composePoint({0.0, along}));
    points.push_back(turn.composePoint({8.0, along}));
  }
  return points;
}

}  // namespace

TEST_CASE("the dominant direction is that of the walls", "[bench][hough_spectrum]") {
  for (const double degrees : {0.0, 10.0, 45.0, 89.0}) {
    const double angle = degrees * M_PI / 180;
    const double found = dominantDirection(houghSpectrum(outline(angle), 360, 0.1));
    CHECK(std::remainder(found - angle, M_PI / 2) == Approx(0).margin(0.0088));
  }
}

TEST_CASE("the spectrum of one point is flat", "[bench][hough_spectrum]") {
  for (const double value : houghSpectrum({{3, 4}}, 8, 0.1)) {
    CHECK(value == 1);
  }
}

TEST_CASE("wall points are the centres of occupied cells", "[bench][hough_spectrum]") {
  StateGrid grid;
  grid.width = 2;
  grid.height = 2;
  grid.resolution = 0.5;
  grid.cells = {CellState::Free, CellState::Unknown, CellState::Free, CellState::Occupied};
  const std::vector<Point2D> points = wallPoints(grid);
  REQUIRE(points.size() == 1);
  CHECK(points[0].x == 0.75);
  CHECK(points[0].y == 0.75);
}
