// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "catch.h"
#include "features/axis_line_worlds.h"
#include "sbox/features/wall_boxes.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

BoxLimits unlimited() {
  BoxLimits limits;
  limits.max_boxes = 1000000;
  return limits;
}

using Key = std::array<long, 6>;

Key keyOf(double left, double lower, double right, double upper, int facing_in, double cover) {
  const auto rounded = [](double value) { return std::lround(value * 1e4); };
  return {rounded(left), rounded(lower), rounded(right), rounded(upper), facing_in, rounded(cover)};
}

/// What can be compared in any order, of boxes with sides along the axes.
std::vector<Key> sortedKeys(const std::vector<WallBox>& boxes) {
  std::vector<Key> keys;
  for (const WallBox& box : boxes) {
    const Vector2d& low = box.corners[0];
    const Vector2d& high = box.corners[2];
    keys.push_back(keyOf(low.x(), low.y(), high.x(), high.y(), box.facing_in, box.cover));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

struct Side {
  AxisLine line;
  bool faces_up;  ///< Or right.
};

std::vector<Side> sidesOf(const AxisLines& lines, size_t up, size_t down) {
  std::vector<Side> sides;
  for (const AxisLine& line : lines[up]) {
    sides.push_back({line, true});
  }
  for (const AxisLine& line : lines[down]) {
    sides.push_back({line, false});
  }
  return sides;
}

/// All ways to take two lines along x and two along y.
std::vector<Key> keysOfAllQuadruples(const AxisLines& lines, const BoxLimits& limits) {
  const std::vector<Side> horizontal = sidesOf(lines, 1, 3), vertical = sidesOf(lines, 0, 2);
  std::vector<Key> keys;
  for (const Side& lower : horizontal) {
    for (const Side& upper : horizontal) {
      for (const Side& left : vertical) {
        for (const Side& right : vertical) {
          const double x0 = left.line.across, x1 = right.line.across;
          const double y0 = lower.line.across, y1 = upper.line.across;
          const std::array<double, 4> cover{right.line.cover(y0, y1), upper.line.cover(x0, x1),
                                            left.line.cover(y0, y1), lower.line.cover(x0, x1)};
          const double mean = (cover[0] + cover[1] + cover[2] + cover[3]) / 4;
          if (x1 - x0 >= limits.min_side && x1 - x0 <= limits.max_side &&
              y1 - y0 >= limits.min_side && y1 - y0 <= limits.max_side &&
              *std::min_element(cover.begin(), cover.end()) >= limits.min_cover &&
              mean >= limits.mean_cover) {
            const int facing_in = (right.faces_up ? 0 : 1) | (upper.faces_up ? 0 : 2) |
                                  (left.faces_up ? 4 : 0) | (lower.faces_up ? 8 : 0);
            keys.push_back(keyOf(x0, y0, x1, y1, facing_in, mean));
          }
        }
      }
    }
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace

TEST_CASE("a room is one box, free inside", "[features]") {
  const auto boxes = findBoxes(test::roomAxisLines());
  REQUIRE(boxes.size() == 1);
  CHECK(boxes[0].corners[0].isApprox(Vector2d(1, 2)));
  CHECK(boxes[0].corners[1].isApprox(Vector2d(7, 2)));
  CHECK(boxes[0].corners[2].isApprox(Vector2d(7, 5)));
  CHECK(boxes[0].corners[3].isApprox(Vector2d(1, 5)));
  CHECK(boxes[0].centre.isApprox(Vector2d(4, 3.5)));
  CHECK(boxes[0].size_x == Approx(6));
  CHECK(boxes[0].size_y == Approx(3));
  CHECK(boxes[0].facing_in == 0xF);
  CHECK(boxes[0].cover == Approx(1));
}

TEST_CASE("a block seen from outside is a box whose sides face away", "[features]") {
  AxisLines lines = test::roomAxisLines();
  std::swap(lines[0], lines[2]);
  std::swap(lines[1], lines[3]);
  const auto boxes = findBoxes(lines);
  REQUIRE(boxes.size() == 1);
  CHECK(boxes[0].facing_in == 0);
}

TEST_CASE("sides may be real in part only", "[features]") {
  AxisLines lines = test::roomAxisLines();
  lines[1][0].high = 1.9;  // 0.15 of the lower side is seen.
  const auto boxes = findBoxes(lines);
  REQUIRE(boxes.size() == 1);
  CHECK(boxes[0].cover == Approx((3 + 0.15) / 4));
  lines[1][0].high = 1.3;
  CHECK(findBoxes(lines).empty());
  BoxLimits limits;
  limits.mean_cover = 0.8;
  lines[1][0].high = 1.9;
  CHECK(findBoxes(lines, limits).empty());
}

TEST_CASE("a side with an end too near or too far makes no box", "[features]") {
  BoxLimits limits;
  limits.min_side = 3.1;
  CHECK(findBoxes(test::roomAxisLines(), limits).empty());
  limits.min_side = 2.9;
  limits.max_side = 5.9;
  CHECK(findBoxes(test::roomAxisLines(), limits).empty());
  limits.max_side = 6.1;
  CHECK(findBoxes(test::roomAxisLines(), limits).size() == 1);
  CHECK(findBoxes(AxisLines{}).empty());
}

TEST_CASE("boxes of tilted walls keep their corners", "[features]") {
  AxisLines lines = test::roomAxisLines();
  lines[1][0].slope = 0.1;
  lines[2][0].slope = -0.05;
  const auto boxes = findBoxes(lines);
  REQUIRE(boxes.size() == 1);
  CHECK(boxes[0].corners[1].isApprox(crossing(lines[1][0], lines[2][0])));
  const auto side = [&](size_t i, size_t j) {
    return (boxes[0].corners[i] - boxes[0].corners[j]).norm();
  };
  CHECK(boxes[0].size_x == Approx((side(0, 1) + side(2, 3)) / 2));
  CHECK(boxes[0].size_y == Approx((side(1, 2) + side(3, 0)) / 2));
}

TEST_CASE("boxes are those of all ways to take two lines against two", "[features]") {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const AxisLines lines = test::randomAxisLines(9, 0, seed);
    BoxLimits limits = unlimited();
    limits.max_side = seed % 2 == 0 ? 12 : 40;
    const auto expected = keysOfAllQuadruples(lines, limits);
    INFO("seed " << seed);
    REQUIRE(expected.size() > 50);
    CHECK(sortedKeys(findBoxes(lines, limits)) == expected);
  }
}

TEST_CASE("turning the lines turns the boxes", "[features]") {
  const AxisLines lines = test::randomAxisLines(7, 0, 11);
  std::vector<WallBox> expected = findBoxes(lines, unlimited());
  for (WallBox& box : expected) {
    // The lower right corner becomes the upper right one, that one the upper left, and so on.
    const std::array<Vector2d, 4> corners = box.corners;
    for (size_t i = 0; i < 4; ++i) {
      box.corners[(i + 1) % 4] = Vector2d(-corners[i].y(), corners[i].x());
    }
    box.facing_in = turned(box.facing_in, 1);
  }
  REQUIRE(!expected.empty());
  CHECK(sortedKeys(findBoxes(test::quarterTurned(lines), unlimited())) == sortedKeys(expected));
}

TEST_CASE("the boxes with the longest real sides are kept", "[features]") {
  const AxisLines lines = test::randomAxisLines(9, 0, 2);
  const auto realSides = [](const std::vector<WallBox>& boxes) {
    std::vector<double> lengths;
    for (const WallBox& box : boxes) {
      lengths.push_back(box.cover * (box.size_x + box.size_y));
    }
    std::sort(lengths.rbegin(), lengths.rend());
    return lengths;
  };
  std::vector<double> expected = realSides(findBoxes(lines, unlimited()));
  BoxLimits limits;
  limits.max_boxes = 12;
  REQUIRE(expected.size() > 100);  // So that the finder must sort out more than once.
  expected.resize(12);
  CHECK(realSides(findBoxes(lines, limits)) == expected);
}
