// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/paper/hough_lines.h"

using namespace sbox;
using test::drawWall;

namespace {

StateGrid drawn(const std::vector<test::Wall>& walls) {
  StateGrid grid = test::freeGrid(200, 160, 0.05);
  for (const test::Wall& wall : walls) {
    drawWall(grid, wall);
  }
  return grid;
}

double distanceToLine(const HoughLine& line, const Point2D& p) {
  return std::abs(p.x * std::cos(line.theta) + p.y * std::sin(line.theta) - line.rho);
}

}  // namespace

TEST_CASE("walls become lines, the longest first", "[paper]") {
  const auto lines =
      findHoughLines(drawn({{{1.02, 3.02}, {6.02, 3.02}}, {{2.02, 1.02}, {2.02, 7.02}}}));
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].theta == Approx(0).margin(0.02));
  CHECK(lines[0].rho == Approx(2.02).margin(0.05));
  CHECK(lines[0].votes >= 118);
  CHECK(lines[0].from.y == Approx(1.02).margin(0.1));
  CHECK(lines[0].to.y == Approx(7.02).margin(0.1));
  CHECK(lines[1].theta == Approx(M_PI / 2).margin(0.02));
  CHECK(lines[1].rho == Approx(3.02).margin(0.05));
}

TEST_CASE("a line follows its wall at any angle", "[paper]") {
  for (int degrees = 0; degrees < 180; degrees += 15) {
    const double angle = degrees * M_PI / 180;
    const Point2D middle(5, 4), reach(3.5 * std::cos(angle), 3.5 * std::sin(angle));
    const auto lines = findHoughLines(drawn({{middle - reach, middle + reach}}));
    INFO(degrees << " degrees");
    REQUIRE(!lines.empty());
    CHECK(distanceToLine(lines[0], middle - reach) < 0.1);
    CHECK(distanceToLine(lines[0], middle + reach) < 0.1);
    const Point2D seen = lines[0].to - lines[0].from;
    CHECK(std::hypot(seen.x, seen.y) == Approx(7).margin(0.3));
  }
}

TEST_CASE("scattered cells that happen to lie on one line are no wall", "[paper]") {
  StateGrid grid = test::freeGrid(400, 20, 0.05);
  for (size_t x = 0; x < 400; x += 10) {
    grid.cells[10 * 400 + x] = CellState::Occupied;  // Forty votes, enough for a wall of 2 m.
  }
  CHECK(findHoughLines(grid).empty());
}

TEST_CASE("the strongest lines are kept", "[paper]") {
  const StateGrid grid =
      drawn({{{1, 1.02}, {4, 1.02}}, {{1, 3.02}, {8, 3.02}}, {{1, 5.02}, {6, 5.02}}});
  HoughOptions options;
  options.max_lines = 2;
  const auto lines = findHoughLines(grid, options);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].rho == Approx(3.02).margin(0.05));
  CHECK(lines[1].rho == Approx(5.02).margin(0.05));
}

TEST_CASE("no lines without walls, and no steps of zero", "[paper]") {
  CHECK(findHoughLines(StateGrid()).empty());
  CHECK(findHoughLines(test::freeGrid(50, 50, 0.05)).empty());
  HoughOptions options;
  options.rho_step = 0;
  CHECK_THROWS_AS(findHoughLines(test::freeGrid(5, 5, 0.05), options), std::invalid_argument);
}
