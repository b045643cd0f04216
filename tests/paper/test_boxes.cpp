// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>
#include <set>

#include "catch.h"
#include "sbox/paper/boxes.h"

using namespace sbox;

namespace {

/// Lines x = xs[i] and y = ys[j] that cross everywhere but where `missing` says so. Lines of x come
/// first; each point is a cluster of its own.
struct Lattice {
  std::vector<VerticalPoint> points;
  std::vector<PointCluster> clusters;
};

Lattice lattice(const std::vector<double>& xs, const std::vector<double>& ys,
                const std::set<std::pair<size_t, size_t>>& missing = {}, double turn = 0) {
  Lattice result;
  for (size_t i = 0; i < xs.size(); ++i) {
    for (size_t j = 0; j < ys.size(); ++j) {
      if (missing.count({i, j}) == 0) {
        const Point2D p(std::cos(turn) * xs[i] - std::sin(turn) * ys[j],
                        std::sin(turn) * xs[i] + std::cos(turn) * ys[j]);
        result.clusters.push_back({p, {static_cast<int>(result.points.size())}});
        result.points.push_back({p, static_cast<int>(i), static_cast<int>(xs.size() + j)});
      }
    }
  }
  return result;
}

std::vector<SuppositionalBox> build(const Lattice& l, const BoxOptions& options) {
  return buildBoxes(l.points, l.clusters, options);
}

BoxOptions wideLimits() {
  BoxOptions options;
  options.min_width = 0.01;
  options.max_height = 1000;
  options.max_boxes = 100000;
  return options;
}

/// Algorithm 1 as printed: from each point along one of its lines to a second, along the other line
/// to a third, and to a fourth that shares a line with both.
size_t countByAlgorithm1(const std::vector<VerticalPoint>& p) {
  std::set<std::set<size_t>> boxes;
  const auto share = [&](size_t i, size_t j, int line) {
    return i != j && (p[i].line1 == line || p[i].line2 == line) &&
           (p[j].line1 == line || p[j].line2 == line);
  };
  const auto other = [&](size_t i, int line) {
    return p[i].line1 == line ? p[i].line2 : p[i].line1;
  };
  for (size_t i = 0; i < p.size(); ++i) {
    for (size_t j1 = 0; j1 < p.size(); ++j1) {
      for (size_t j2 = 0; j2 < p.size(); ++j2) {
        if (share(i, j1, p[i].line1) && share(i, j2, p[i].line2)) {
          const int line3 = other(j1, p[i].line1), line4 = other(j2, p[i].line2);
          for (size_t j3 = 0; j3 < p.size(); ++j3) {
            if (share(j1, j3, line3) && share(j2, j3, line4)) {
              boxes.insert({i, j1, j2, j3});
            }
          }
        }
      }
    }
  }
  return boxes.size();
}

}  // namespace

TEST_CASE("eq. 3 describes a box", "[paper]") {
  const SuppositionalBox box = describeBox({{{4, 6}, {4, 1}, {1, 1}, {1, 6}}});
  CHECK(box.height == Approx(5));
  CHECK(box.width == Approx(3));
  CHECK(box.area == Approx(15));
  CHECK(box.centre.x == Approx(2.5));
  CHECK(box.centre.y == Approx(3.5));
  const std::array<Point2D, 4> expected = {{{1, 1}, {4, 1}, {4, 6}, {1, 6}}};
  for (size_t i = 0; i < 4; ++i) {
    CHECK(box.corners[i].x == expected[i].x);
    CHECK(box.corners[i].y == expected[i].y);
  }
}

TEST_CASE("corners run counter-clockwise from the lower left, however given", "[paper]") {
  std::array<Point2D, 4> loop = {{{1, 1}, {4, 2}, {3, 5}, {0, 4}}};
  for (int way = 0; way < 2; ++way) {
    for (int i = 0; i < 4; ++i) {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      const SuppositionalBox box = describeBox(loop);
      CHECK(box.corners[0].x == 1);
      CHECK(box.corners[1].x == 4);
      CHECK(box.corners[2].x == 3);
    }
    std::reverse(loop.begin(), loop.end());
  }
}

TEST_CASE("two lines against two make one box, three against two make three", "[paper]") {
  CHECK(build(lattice({0, 2}, {0, 3}), wideLimits()).size() == 1);
  CHECK(build(lattice({0, 2, 5}, {0, 3}), wideLimits()).size() == 3);
  CHECK(build(lattice({0, 2, 5}, {0, 3}, {}, 0.7), wideLimits()).size() == 3);
  CHECK(build(lattice({0, 2}, {0, 3}, {{1, 1}}), wideLimits()).empty());
  CHECK(build(lattice({0, 2}, {}), wideLimits()).empty());
}

TEST_CASE("as many boxes as Algorithm 1 finds", "[paper]") {
  std::mt19937 random(11);
  for (int trial = 0; trial < 8; ++trial) {
    std::set<std::pair<size_t, size_t>> missing;
    for (int i = 0; i < 8; ++i) {
      missing.insert({random() % 5, random() % 4});
    }
    const Lattice l = lattice({0, 1, 3, 7, 15}, {0, 2, 5, 11}, missing, 0.3);
    CHECK(build(l, wideLimits()).size() == countByAlgorithm1(l.points));
  }
}

TEST_CASE("limits keep out flat and giant boxes, and the largest are kept", "[paper]") {
  BoxOptions options = wideLimits();
  options.min_width = 2;
  options.max_height = 6;
  const Lattice l = lattice({0, 1, 4, 9}, {0, 5});
  // Widths 1, 3, 5, 4, 8, 9 by 5: those of 3, 4 and 5 stay.
  const auto boxes = build(l, options);
  REQUIRE(boxes.size() == 3);
  CHECK(boxes[0].area == Approx(25));
  CHECK(boxes[2].area == Approx(15));
  options.max_boxes = 1;
  REQUIRE(build(l, options).size() == 1);
  CHECK(build(l, options)[0].area == Approx(25));
}

TEST_CASE("boxes through the same clusters are one", "[paper]") {
  // Two nearly equal walls at x = 0 and 0.1, whose points were clustered.
  Lattice l = lattice({0, 0.1, 4}, {0, 3});
  l.clusters = {{{0.05, 0}, {0, 2}}, {{0.05, 3}, {1, 3}}, {{4, 0}, {4}}, {{4, 3}, {5}}};
  const auto boxes = build(l, wideLimits());
  REQUIRE(boxes.size() == 1);
  CHECK(boxes[0].corners[0].x == Approx(0.05));
}

TEST_CASE("points whose cluster was filtered out make no box", "[paper]") {
  Lattice l = lattice({0, 2}, {0, 3});
  l.clusters.pop_back();
  CHECK(build(l, wideLimits()).empty());
}
