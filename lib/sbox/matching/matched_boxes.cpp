// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/matching/matched_boxes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace sbox {
namespace {

using Corners = std::array<Eigen::Vector2d, 4>;

Corners inGrid(const WallBox& box, const WallFrame& frame) {
  const Eigen::Matrix2d to_grid = Eigen::Rotation2Dd(frame.direction).toRotationMatrix();
  Corners corners;
  for (size_t i = 0; i < 4; ++i) {
    corners[i] = to_grid * box.corners[i];
  }
  return corners;
}

/// A box of map a in its grid frame.
struct Target {
  const WallBox* box;
  int index;
  Corners corners;
  double centre_x;
};

/// The boxes of a frame sorted by where they lie, so that near ones are found by halving.
std::vector<Target> targetsOf(const FrameFeatures& frame, int first_index) {
  std::vector<Target> targets;
  for (size_t i = 0; i < frame.boxes.size(); ++i) {
    const Corners corners = inGrid(frame.boxes[i], frame.frame);
    const double x = (corners[0] + corners[1] + corners[2] + corners[3]).x() / 4;
    targets.push_back({&frame.boxes[i], first_index + static_cast<int>(i), corners, x});
  }
  std::sort(targets.begin(), targets.end(), [](const Target& left, const Target& right) {
    return std::make_pair(left.centre_x, left.index) < std::make_pair(right.centre_x, right.index);
  });
  return targets;
}

/// The quarter turns between two frames under a heading; none if their axes do not line up.
std::optional<int> quarterTurns(const WallFrame& a, const WallFrame& b, double heading) {
  const double turns = (heading + b.direction - a.direction) / (M_PI / 2);
  const double nearest = std::round(turns);
  constexpr double max_off = 0.1;  // Of a quarter turn: 9 degrees.
  if (std::abs(turns - nearest) > max_off) {
    return std::nullopt;
  }
  return static_cast<int>(nearest);
}

}  // namespace

std::vector<BoxMatch> matchBoxes(const MapFeatures& a, const MapFeatures& b,
                                 const RigidTransform& b_in_a, const DriftField& drift,
                                 const BoxMatchOptions& options) {
  std::vector<BoxMatch> matches;
  const PointMover to_a(b_in_a);
  int first_a = 0;
  for (const FrameFeatures& frame_a : a.frames) {
    const std::vector<Target> targets = targetsOf(frame_a, first_a);
    first_a += static_cast<int>(frame_a.boxes.size());
    int first_b = 0;
    for (const FrameFeatures& frame_b : b.frames) {
      const std::optional<int> turns = quarterTurns(frame_a.frame, frame_b.frame, b_in_a.heading);
      for (size_t j = 0; turns && j < frame_b.boxes.size(); ++j) {
        const WallBox& box_b = frame_b.boxes[j];
        const Corners corners_b = inGrid(box_b, frame_b.frame);
        Corners moved;
        double x = 0;
        for (size_t i = 0; i < 4; ++i) {
          moved[i] = to_a(corners_b[i]);
          moved[i] += drift.at(moved[i]);
          x += moved[i].x() / 4;
        }
        auto target =
            std::lower_bound(targets.begin(), targets.end(), x - options.corner_distance,
                             [](const Target& t, double value) { return t.centre_x < value; });
        const Target* best = nullptr;
        double best_distance = options.corner_distance;
        const auto shift = static_cast<size_t>(((*turns % 4) + 4) % 4);
        for (; target != targets.end() && target->centre_x <= x + options.corner_distance;
             ++target) {
          if (target->box->facing_in != turned(box_b.facing_in, *turns)) {
            continue;
          }
          double distance = 0;
          for (size_t i = 0; i < 4; ++i) {
            distance = std::max(distance, (target->corners[(i + shift) % 4] - moved[i]).norm());
          }
          if (distance < best_distance) {
            best_distance = distance;
            best = &*target;
          }
        }
        if (best != nullptr) {
          BoxMatch match{best->index, first_b + static_cast<int>(j), {}, corners_b};
          for (size_t i = 0; i < 4; ++i) {
            match.corners_a[i] = best->corners[(i + shift) % 4];
          }
          matches.push_back(match);
        }
      }
      first_b += static_cast<int>(frame_b.boxes.size());
    }
  }
  return matches;
}

}  // namespace sbox
