// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Walls of two maps that a transform lays near each other.
#pragma once

#include <algorithm>

#include "sbox/core/rigid_transform.h"
#include "sbox/features/field_lookup.h"
#include "sbox/features/map_features.h"

namespace sbox {

/// Pairs the first `most_points` wall points of each map with the nearest of the other that faces
/// the same way, if one is within reach of the fields: calls from_b(point_b, place, wall_a), where
/// `place` is that of the point in the grid frame of a, then from_a(point_a, place, wall_b), where
/// it is in that of b. In order.
template <typename FromB, typename FromA>
void forEachWallPair(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
                     size_t most_points, const FromB& from_b, const FromA& from_a) {
  const PointMover to_a(b_in_a), to_b(b_in_a.inverse());
  const ByteAngle turn = toByteAngle(b_in_a.heading);
  forEachNearest(
      a.fields, a.wall_points, std::min(most_points, b.wall_points.size()),
      [&](size_t i) { return to_a(b.wall_points[i].position); },
      [&](size_t i) { return static_cast<ByteAngle>(b.wall_directions[i] + turn); },
      [&](size_t i, const Eigen::Vector2d& place, const WallPoint& wall) {
        from_b(b.wall_points[i], place, wall);
      });
  forEachNearest(
      b.fields, b.wall_points, std::min(most_points, a.wall_points.size()),
      [&](size_t i) { return to_b(a.wall_points[i].position); },
      [&](size_t i) { return static_cast<ByteAngle>(a.wall_directions[i] - turn); },
      [&](size_t i, const Eigen::Vector2d& place, const WallPoint& wall) {
        from_a(a.wall_points[i], place, wall);
      });
}

}  // namespace sbox
