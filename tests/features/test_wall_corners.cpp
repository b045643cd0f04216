// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "catch.h"
#include "features/axis_line_worlds.h"
#include "sbox/features/wall_corners.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

constexpr QuarterMask kRight = 1, kUp = 2, kLeft = 4, kDown = 8;

CornerOptions unlimited() {
  CornerOptions options;
  options.max_corners = 1000000;
  return options;
}

using Key = std::tuple<long, long, int, int, long>;

/// What can be compared in any order; positions and strengths to a tenth of a millimetre.
std::vector<Key> sortedKeys(const std::vector<WallCorner>& corners) {
  std::vector<Key> keys;
  for (const WallCorner& corner : corners) {
    keys.emplace_back(std::lround(corner.position.x() * 1e4),
                      std::lround(corner.position.y() * 1e4), corner.free_sides, corner.arms,
                      std::lround(corner.strength * 1e4));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// One line along x that faces up and one along y that faces right.
AxisLines two(const AxisLine& along_x, const AxisLine& along_y) {
  AxisLines lines;
  lines[1] = {along_x};
  lines[0] = {along_y};
  return lines;
}

}  // namespace

TEST_CASE("masks turn with what they describe", "[features]") {
  CHECK(turned(kRight, 1) == kUp);
  CHECK(turned(kDown, 1) == kRight);
  CHECK(turned(kRight | kUp, 2) == (kLeft | kDown));
  CHECK(turned(kRight | kUp, -1) == (kDown | kRight));
  CHECK(turned(kLeft, 4) == kLeft);
  CHECK(turned(0xF, 3) == 0xF);
}

TEST_CASE("tilted lines cross where both say", "[features]") {
  const AxisLine along_x{0, 10, 3, 0.1, 1}, along_y{0, 8, 6, -0.05, 1};
  const Vector2d p = crossing(along_x, along_y);
  CHECK(along_x.acrossAt(p.x()) == Approx(p.y()));
  CHECK(along_y.acrossAt(p.y()) == Approx(p.x()));
  CHECK(crossing({0, 10, 3, 0, 1}, {0, 8, 6, 0, 1}).isApprox(Vector2d(6, 3)));
}

TEST_CASE("a room has four corners whose arms run along its walls", "[features]") {
  const auto corners = findCorners(test::roomAxisLines());
  CHECK(sortedKeys(corners) == sortedKeys({{{1, 2}, kRight | kUp, kRight | kUp, 3.0},
                                           {{7, 2}, kLeft | kUp, kLeft | kUp, 3.0},
                                           {{7, 5}, kLeft | kDown, kLeft | kDown, 3.0},
                                           {{1, 5}, kRight | kDown, kRight | kDown, 3.0}}));
}

TEST_CASE("a line that runs past has two arms, one that ends short of the corner one",
          "[features]") {
  // The line along y ends 2 m above the other, which runs past it.
  const auto corners = findCorners(two({0, 10, 1, 0, 1}, {3, 8, 4, 0, 1}));
  REQUIRE(corners.size() == 1);
  CHECK(corners[0].position.isApprox(Vector2d(4, 1)));
  CHECK(corners[0].free_sides == (kRight | kUp));
  CHECK(corners[0].arms == (kRight | kLeft | kUp));
  // The upright line is the shorter one.
  CHECK(corners[0].strength == Approx(5));
}

TEST_CASE("lines that end too far from where they would meet make no corner", "[features]") {
  CHECK(findCorners(two({0, 10, 1, 0, 1}, {3.9, 8, 4, 0, 1})).size() == 1);
  CHECK(findCorners(two({0, 10, 1, 0, 1}, {4.1, 8, 4, 0, 1})).empty());
  CHECK(findCorners(two({7.1, 10, 1, 0, 1}, {1, 8, 4, 0, 1})).empty());
  CHECK(findCorners(AxisLines{}).empty());
}

TEST_CASE("corners are those of all pairs of perpendicular lines", "[features]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const AxisLines lines = test::randomAxisLines(12, 0.05, seed);
    std::vector<WallCorner> expected;
    for (const size_t side_x : {0, 2}) {
      for (const size_t side_y : {1, 3}) {
        for (const AxisLine& v : lines[side_x]) {
          for (const AxisLine& h : lines[side_y]) {
            const Vector2d p = crossing(h, v);
            const auto off = [](const AxisLine& line, double at) {
              return at < line.low ? line.low - at : at > line.high ? at - line.high : 0;
            };
            if (off(h, p.x()) > 3 || off(v, p.y()) > 3) {
              continue;
            }
            int arms = h.high - p.x() >= 0.4 ? kRight : 0;
            arms |= p.x() - h.low >= 0.4 ? kLeft : 0;
            arms |= v.high - p.y() >= 0.4 ? kUp : 0;
            arms |= p.y() - v.low >= 0.4 ? kDown : 0;
            const auto arm = [](const AxisLine& line, double at) {
              return std::min(std::max(line.high - at, at - line.low), line.high - line.low);
            };
            const double strength = std::min(arm(h, p.x()), arm(v, p.y()));
            expected.push_back({p, static_cast<QuarterMask>((1U << side_x) | (1U << side_y)),
                                static_cast<QuarterMask>(arms), strength});
          }
        }
      }
    }
    INFO("seed " << seed);
    REQUIRE(expected.size() > 20);
    CHECK(sortedKeys(findCorners(lines, unlimited())) == sortedKeys(expected));
  }
}

TEST_CASE("turning the lines turns the corners", "[features]") {
  const AxisLines lines = test::randomAxisLines(8, 0.03, 5);
  std::vector<WallCorner> expected = findCorners(lines, unlimited());
  for (WallCorner& corner : expected) {
    corner.position = Vector2d(-corner.position.y(), corner.position.x());
    corner.free_sides = turned(corner.free_sides, 1);
    corner.arms = turned(corner.arms, 1);
  }
  CHECK(sortedKeys(findCorners(test::quarterTurned(lines), unlimited())) == sortedKeys(expected));
}

TEST_CASE("the corners with the longest arms are kept", "[features]") {
  const AxisLines lines = test::randomAxisLines(12, 0, 4);
  std::vector<double> all, kept;
  for (const WallCorner& corner : findCorners(lines, unlimited())) {
    all.push_back(corner.strength);
  }
  CornerOptions options;
  options.max_corners = 10;
  for (const WallCorner& corner : findCorners(lines, options)) {
    kept.push_back(corner.strength);
  }
  std::sort(all.rbegin(), all.rend());
  std::sort(kept.rbegin(), kept.rend());
  REQUIRE(all.size() > 10);
  all.resize(10);
  CHECK(kept == all);
}

TEST_CASE("the corner of long tilted lines is found", "[features]") {
  for (const double slope : {0.01, 0.1, 0.3}) {
    for (const double reach : {0.0, 3.0}) {
      CornerOptions options = unlimited();
      options.reach = reach;
      // The first ends where the second stands.
      const AxisLine along_x{0, 160, 20, slope, 1};
      const double end = along_x.acrossAt(160);
      const AxisLine along_y{end - 1e-9, end + 5, 160, 0, 1};
      INFO("slope " << slope << ", reach " << reach);
      const auto corners = findCorners(two(along_x, along_y), options);
      REQUIRE(corners.size() == 1);
      CHECK(corners[0].position.x() == Approx(160));
      CHECK(corners[0].position.y() == Approx(end));
    }
  }
}
