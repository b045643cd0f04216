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

/// A box of map b, and where it comes to lie in the grid frame of map a.
struct Moved {
  const WallBox* box;
  Corners corners_in_b;
  Corners corners_in_a;
  double centre_x = 0;
};

Moved moveBox(const WallBox& box, const WallFrame& frame, const PointMover& to_a,
              const DriftField& drift) {
  Moved moved{&box, inGrid(box, frame), {}};
  for (size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d rigid = to_a(moved.corners_in_b[i]);
    moved.corners_in_a[i] = rigid + drift.at(rigid);
    moved.centre_x += moved.corners_in_a[i].x() / 4;
  }
  return moved;
}

/// The target's corners in the order of a box whose frame is turned by so many quarters.
Corners turnedCorners(const Target& target, int turns) {
  const auto shift = static_cast<size_t>(((turns % 4) + 4) % 4);
  Corners corners;
  for (size_t i = 0; i < 4; ++i) {
    corners[i] = target.corners[(i + shift) % 4];
  }
  return corners;
}

double farthestCorners(const Corners& left, const Corners& right) {
  double distance = 0;
  for (size_t i = 0; i < 4; ++i) {
    distance = std::max(distance, (left[i] - right[i]).norm());
  }
  return distance;
}

/// The target that the moved box lies on, if all its corners are nearer than `corner_distance`.
const Target* targetBelow(const Moved& moved, const std::vector<Target>& targets, int turns,
                          double corner_distance) {
  const QuarterMask facing_in = turned(moved.box->facing_in, turns);
  const Target* best = nullptr;
  double best_distance = corner_distance;
  auto target = std::lower_bound(targets.begin(), targets.end(), moved.centre_x - corner_distance,
                                 [](const Target& t, double value) { return t.centre_x < value; });
  for (; target != targets.end() && target->centre_x <= moved.centre_x + corner_distance;
       ++target) {
    if (target->box->facing_in != facing_in) {
      continue;
    }
    const double distance = farthestCorners(turnedCorners(*target, turns), moved.corners_in_a);
    if (distance < best_distance) {
      best_distance = distance;
      best = &*target;
    }
  }
  return best;
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
        const Moved moved = moveBox(frame_b.boxes[j], frame_b.frame, to_a, drift);
        if (const Target* target = targetBelow(moved, targets, *turns, options.corner_distance)) {
          matches.push_back({target->index, first_b + static_cast<int>(j),
                             turnedCorners(*target, *turns), moved.corners_in_b});
        }
      }
      first_b += static_cast<int>(frame_b.boxes.size());
    }
  }
  return matches;
}

}  // namespace sbox
