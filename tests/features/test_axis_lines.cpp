// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/features/axis_lines.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

/// A line of a wall below free space, which faces +y: free space is to the left of its walk.
WallLine facingUp(double x_from, double x_to, double y_from, double y_to, double wall_share = 1) {
  return {{x_from, y_from}, {x_to, y_to}, wall_share};
}

WallLine facingUp(double x_from, double x_to, double y) { return facingUp(x_from, x_to, y, y); }

/// The four lines of a room, seen from inside.
std::vector<WallLine> roomLines() {
  return {{{1, 2}, {7, 2}, 1}, {{7, 2}, {7, 5}, 1}, {{7, 5}, {1, 5}, 1}, {{1, 5}, {1, 2}, 1}};
}

std::vector<WallLine> turned(std::vector<WallLine> lines, double angle) {
  const Eigen::Rotation2Dd turn(angle);
  for (WallLine& line : lines) {
    line.from = turn * line.from;
    line.to = turn * line.to;
  }
  return lines;
}

void checkLine(const std::vector<AxisLine>& lines, double low, double high, double across) {
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].low == Approx(low));
  CHECK(lines[0].high == Approx(high));
  CHECK(lines[0].across == Approx(across));
  CHECK(lines[0].slope == Approx(0).margin(1e-12));
}

}  // namespace

TEST_CASE("lines are sorted by the side they face, in the axes of any frame", "[features]") {
  for (const double direction : {0.0, 0.3, 1.2}) {
    INFO("frame at " << direction);
    const AxisLines lines = linesOfFrame(turned(roomLines(), direction), {direction, 1});
    checkLine(lines[0], 2, 5, 1);  // The left wall faces +x.
    checkLine(lines[1], 1, 7, 2);
    checkLine(lines[2], 2, 5, 7);
    checkLine(lines[3], 1, 7, 5);
  }
}

TEST_CASE("a wall goes on behind a door", "[features]") {
  checkLine(linesOfFrame({facingUp(0, 3, 2), facingUp(4, 9, 2)}, {})[1], 0, 9, 2);
  const AxisLines far = linesOfFrame({facingUp(0, 3, 2), facingUp(6, 9, 2)}, {});
  CHECK(far[1].size() == 2);
  const AxisLines beside = linesOfFrame({facingUp(0, 3, 2), facingUp(4, 9, 2.5)}, {});
  REQUIRE(beside[1].size() == 2);
  CHECK(beside[1][0].across < beside[1][1].across);
  // The other face of the wall is another line.
  const WallLine other_face{{9, 1.9}, {4, 1.9}, 1};
  const AxisLines faces = linesOfFrame({facingUp(0, 3, 2), other_face}, {});
  CHECK(faces[1].size() == 1);
  CHECK(faces[3].size() == 1);
}

TEST_CASE("a bent line keeps its slope, one that is far off the axes is left out", "[features]") {
  const AxisLines lines = linesOfFrame({facingUp(0, 10, 2, 3), facingUp(0, 10, 20, 26)}, {});
  REQUIRE(lines[1].size() == 1);
  const AxisLine& line = lines[1][0];
  CHECK(line.slope == Approx(0.1));
  CHECK(line.across == Approx(2.5));
  CHECK(line.acrossAt(0) == Approx(2));
  CHECK(line.acrossAt(10) == Approx(3));
}

TEST_CASE("the edge of the unknown is no line", "[features]") {
  const AxisLines lines =
      linesOfFrame({facingUp(0, 4, 2, 2, 0.1), facingUp(0, 6, 5, 5, 0.5), facingUp(7, 10, 5)}, {});
  REQUIRE(lines[1].size() == 1);
  CHECK(lines[1][0].wall_share == Approx((6 * 0.5 + 3) / 9));
}

TEST_CASE("cover is the share of a stretch that a line runs along", "[features]") {
  AxisLine line;
  line.low = 2;
  line.high = 6;
  CHECK(line.cover(2, 6) == 1);
  CHECK(line.cover(3, 5) == 1);
  CHECK(line.cover(0, 8) == Approx(0.5));
  CHECK(line.cover(5, 7) == Approx(0.5));
  CHECK(line.cover(6, 9) == 0);
  CHECK(line.cover(4, 4) == 0);
}

TEST_CASE("a joined line is the least squares line of all its points", "[features]") {
  const std::vector<WallLine> stretches{facingUp(0, 4, 2, 2.1), facingUp(5, 6, 2.15, 2.1),
                                        facingUp(7, 12, 2.2, 2.4)};
  const AxisLines lines = linesOfFrame(stretches, {});
  REQUIRE(lines[1].size() == 1);
  // The same from very many points.
  double n = 0, u = 0, v = 0, uu = 0, uv = 0;
  for (const WallLine& stretch : stretches) {
    const int count = static_cast<int>(1000 * (stretch.to.x() - stretch.from.x()));
    for (int i = 0; i < count; ++i) {
      const Vector2d p = stretch.from + (stretch.to - stretch.from) * ((i + 0.5) / count);
      n += 1;
      u += p.x();
      v += p.y();
      uu += p.x() * p.x();
      uv += p.x() * p.y();
    }
  }
  const double slope = (uv - u * v / n) / (uu - u * u / n);
  CHECK(lines[1][0].slope == Approx(slope).margin(1e-5));
  CHECK(lines[1][0].across == Approx(v / n + slope * (6 - u / n)).margin(1e-5));
}

TEST_CASE("stretches are joined as if each were compared with each", "[features]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 30), length(0.5, 4), across(0, 4);
  for (int round = 0; round < 20; ++round) {
    std::vector<WallLine> lines;
    for (int i = 0; i < 25; ++i) {
      const double from = place(random);
      lines.push_back(facingUp(from, from + length(random), across(random)));
    }
    // Groups by spreading over all pairs until nothing changes.
    std::vector<size_t> group(lines.size());
    for (size_t i = 0; i < lines.size(); ++i) {
      group[i] = i;
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (size_t i = 0; i < lines.size(); ++i) {
        for (size_t j = 0; j < lines.size(); ++j) {
          const double gap = std::max(lines[i].from.x(), lines[j].from.x()) -
                             std::min(lines[i].to.x(), lines[j].to.x());
          if (gap <= 2.5 && std::abs(lines[i].from.y() - lines[j].from.y()) <= 0.3 &&
              group[j] < group[i]) {
            group[i] = group[j];
            changed = true;
          }
        }
      }
    }
    std::vector<std::pair<double, double>> expected, found;
    for (size_t g = 0; g < lines.size(); ++g) {
      double low = 1e9, high = -1e9;
      for (size_t i = 0; i < lines.size(); ++i) {
        if (group[i] == g) {
          low = std::min(low, lines[i].from.x());
          high = std::max(high, lines[i].to.x());
        }
      }
      if (high > low) {
        expected.emplace_back(low, high);
      }
    }
    const AxisLines joined = linesOfFrame(lines, {});
    for (const AxisLine& line : joined[1]) {
      found.emplace_back(line.low, line.high);
    }
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
  }
}
