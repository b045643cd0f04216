// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "catch.h"
#include "sbox/matching/matched_boxes.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

WallBox boxBetween(const Vector2d& low, const Vector2d& high, QuarterMask facing_in) {
  WallBox box;
  box.corners = {low, Vector2d(high.x(), low.y()), high, Vector2d(low.x(), high.y())};
  box.centre = 0.5 * (low + high);
  box.size_x = high.x() - low.x();
  box.size_y = high.y() - low.y();
  box.facing_in = facing_in;
  return box;
}

/// Boxes anywhere in 30 m x 20 m, in two frames.
MapFeatures randomBoxes(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  MapFeatures map;
  map.width = 30;
  map.height = 20;
  for (const double direction : {0.3, 0.9}) {
    FrameFeatures frame;
    frame.frame.direction = direction;
    for (int i = 0; i < count; ++i) {
      const Vector2d low(between(0, 20), between(0, 14));
      const auto sides = static_cast<QuarterMask>(std::uniform_int_distribution<int>(0, 1)(random));
      frame.boxes.push_back(
          boxBetween(low, low + Vector2d(between(1, 6), between(1, 6)), sides == 0 ? 15 : 7));
    }
    map.frames.push_back(frame);
  }
  return map;
}

/// The same boxes as another robot would draw them: moved, each corner off by a little, the axes of
/// the frame named by another quarter turn.
MapFeatures seenFrom(const MapFeatures& a, const RigidTransform& b_in_a, int turns, double noise,
                     unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-noise, noise);
  MapFeatures b = a;
  for (FrameFeatures& frame : b.frames) {
    const double direction_in_b = frame.frame.direction - b_in_a.heading + turns * M_PI / 2;
    const Eigen::Rotation2Dd to_grid_a(frame.frame.direction), to_frame_b(-direction_in_b);
    for (WallBox& box : frame.boxes) {
      std::array<Vector2d, 4> corners;
      for (size_t i = 0; i < 4; ++i) {
        // Corners are named from the frame's own lower left.
        corners[i] = to_frame_b * (b_in_a.inverse() *
                                   (to_grid_a * box.corners[(i + static_cast<size_t>(turns)) % 4] +
                                    Vector2d(off(random), off(random))));
      }
      box.corners = corners;
      box.facing_in = turned(box.facing_in, 4 - turns);
    }
    frame.frame.direction = direction_in_b;
  }
  return b;
}

std::array<Vector2d, 4> cornersInGrid(const FrameFeatures& frame, size_t box) {
  std::array<Vector2d, 4> corners = frame.boxes[box].corners;
  for (Vector2d& corner : corners) {
    corner = Eigen::Rotation2Dd(frame.frame.direction) * corner;
  }
  return corners;
}

/// Which box of a each box of b lies on, by asking all pairs of all frames; every quarter turn of
/// the names of the corners is tried. Pairs of indices into all boxes of a map.
std::set<std::pair<int, int>> matchAllPairs(const MapFeatures& a, const MapFeatures& b,
                                            const RigidTransform& b_in_a, const DriftField& drift,
                                            double limit) {
  std::set<std::pair<int, int>> matches;
  int first_a = 0;
  for (const FrameFeatures& frame_a : a.frames) {
    int first_b = 0;
    for (const FrameFeatures& frame_b : b.frames) {
      for (size_t j = 0; j < frame_b.boxes.size(); ++j) {
        std::array<Vector2d, 4> moved = cornersInGrid(frame_b, j);
        for (Vector2d& corner : moved) {
          corner = b_in_a * corner;
          corner += drift.at(corner);
        }
        double nearest = limit;
        int best = -1;
        for (size_t i = 0; i < frame_a.boxes.size(); ++i) {
          const auto corners_a = cornersInGrid(frame_a, i);
          for (size_t turn = 0; turn < 4; ++turn) {
            double distance = 0;
            for (size_t k = 0; k < 4; ++k) {
              distance = std::max(distance, (corners_a[(k + turn) % 4] - moved[k]).norm());
            }
            // The sides named by b's frame are a's turned by as much.
            const bool same_sides = frame_a.boxes[i].facing_in ==
                                    turned(frame_b.boxes[j].facing_in, static_cast<int>(turn));
            if (same_sides && distance < nearest) {
              nearest = distance;
              best = static_cast<int>(i);
            }
          }
        }
        if (best >= 0) {
          matches.emplace(first_a + best, first_b + static_cast<int>(j));
        }
      }
      first_b += static_cast<int>(frame_b.boxes.size());
    }
    first_a += static_cast<int>(frame_a.boxes.size());
  }
  return matches;
}

DriftField tilted() {
  DriftField drift;
  drift.spacing = 10;
  drift.columns = 4;
  drift.rows = 4;
  drift.origin = Vector2d(-20, -20);
  drift.displacements.clear();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      drift.displacements.emplace_back(0.1 * column, -0.1 * row);
    }
  }
  return drift;
}

}  // namespace

TEST_CASE("boxes match that all pairs say lie on each other", "[matching]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-3, 3), shift(-5, 5);
  int seen = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const MapFeatures a = randomBoxes(seed, 60);
    for (int turns = 0; turns < 4; ++turns) {
      const RigidTransform truth{angle(random), {shift(random), shift(random)}};
      const MapFeatures b = seenFrom(a, truth, turns, 0.3, seed + 10);
      // A little beside the truth, so that some boxes are out of reach.
      const RigidTransform b_in_a{truth.heading + 0.01, truth.translation + Vector2d(0.1, -0.1)};
      for (const DriftField& drift : {DriftField(), tilted()}) {
        const auto expected = matchAllPairs(a, b, b_in_a, drift, BoxMatchOptions().corner_distance);
        std::set<std::pair<int, int>> found;
        for (const BoxMatch& match : matchBoxes(a, b, b_in_a, drift)) {
          found.emplace(match.a, match.b);
        }
        INFO("seed " << seed << " turns " << turns);
        CHECK(found == expected);
        seen += static_cast<int>(expected.size());
      }
    }
  }
  CHECK(seen > 300);
}

TEST_CASE("corners of matched boxes are named alike", "[matching]") {
  const MapFeatures a = randomBoxes(1, 40);
  const RigidTransform truth{0.7, {2, -1}};
  for (int turns = 0; turns < 4; ++turns) {
    const MapFeatures b = seenFrom(a, truth, turns, 0.01, 5);
    const auto matches = matchBoxes(a, b, truth, DriftField());
    CHECK(matches.size() == 80);
    for (const BoxMatch& match : matches) {
      CHECK(match.a == match.b);
      for (size_t i = 0; i < 4; ++i) {
        CHECK((truth * match.corners_b[i] - match.corners_a[i]).norm() < 0.02);
      }
    }
  }
}

TEST_CASE("boxes of frames that do not line up are not compared", "[matching]") {
  const MapFeatures a = randomBoxes(1, 40);
  const MapFeatures b = seenFrom(a, {}, 0, 0, 5);
  CHECK(matchBoxes(a, b, {0.7, {0, 0}}, DriftField()).empty());
  CHECK(matchBoxes(a, MapFeatures(), {}, DriftField()).empty());
}
