// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/mean_transform.h"

#include <vector>

#include "sbox/core/rigid_fit.h"

namespace sbox {
namespace {

/// Whether a wall that faces `direction` stands near the point.
bool hasWall(const WallFields& fields, const Eigen::Vector2d& point, ByteAngle direction) {
  constexpr double near = 0.25;  // Metres, as the last kernel of the drift field.
  const std::ptrdiff_t cell = fields.cellAt(point.x(), point.y());
  if (cell < 0) {
    return false;
  }
  const std::uint8_t distance = fields.distances[sectorOf(direction)][static_cast<size_t>(cell)];
  return distance * WallFields::unit < near;
}

}  // namespace

RigidTransform meanTransform(const MapFeatures& a, const MapFeatures& b,
                             const RigidTransform& b_in_a, const DriftField& drift) {
  std::vector<Point2D> from, to;
  const auto add = [&](const Eigen::Vector2d& in_b, const Eigen::Vector2d& in_a) {
    from.emplace_back(in_b.x(), in_b.y());
    to.emplace_back(in_a.x(), in_a.y());
  };
  const PointMover to_a(b_in_a), to_b(b_in_a.inverse());
  const ByteAngle turn = toByteAngle(b_in_a.heading);
  for (size_t i = 0; i < b.wall_points.size(); ++i) {
    const Eigen::Vector2d& point = b.wall_points[i].position;
    const Eigen::Vector2d rigid = to_a(point);
    const Eigen::Vector2d bent = rigid + drift.at(rigid);
    if (hasWall(a.fields, bent, static_cast<ByteAngle>(b.wall_directions[i] + turn))) {
      add(point, bent);
    }
  }
  for (size_t i = 0; i < a.wall_points.size(); ++i) {
    const Eigen::Vector2d& point = a.wall_points[i].position;
    const Eigen::Vector2d in_b = to_b(point - drift.at(point));
    if (hasWall(b.fields, in_b, static_cast<ByteAngle>(a.wall_directions[i] - turn))) {
      add(in_b, point);
    }
  }
  if (from.size() < 2) {
    return b_in_a;
  }
  const Pose2D mean = fitRigid(from, to);
  return {mean.phi, {mean.x, mean.y}};
}

}  // namespace sbox
