// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/mean_transform.h"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

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
  std::vector<Eigen::Vector2d> from, to;
  const PointMover to_a(b_in_a), to_b(b_in_a.inverse());
  const ByteAngle turn = toByteAngle(b_in_a.heading);
  for (size_t i = 0; i < b.wall_points.size(); ++i) {
    const Eigen::Vector2d& point = b.wall_points[i].position;
    const Eigen::Vector2d rigid = to_a(point);
    const Eigen::Vector2d bent = rigid + drift.at(rigid);
    if (hasWall(a.fields, bent, static_cast<ByteAngle>(b.wall_directions[i] + turn))) {
      from.push_back(point);
      to.push_back(bent);
    }
  }
  for (size_t i = 0; i < a.wall_points.size(); ++i) {
    const Eigen::Vector2d& point = a.wall_points[i].position;
    const Eigen::Vector2d in_b = to_b(point - drift.at(point));
    if (hasWall(b.fields, in_b, static_cast<ByteAngle>(a.wall_directions[i] - turn))) {
      from.push_back(in_b);
      to.push_back(point);
    }
  }
  if (from.size() < 2) {
    return b_in_a;
  }
  Eigen::Vector2d mean_from = Eigen::Vector2d::Zero(), mean_to = Eigen::Vector2d::Zero();
  for (size_t i = 0; i < from.size(); ++i) {
    mean_from += from[i];
    mean_to += to[i];
  }
  mean_from /= static_cast<double>(from.size());
  mean_to /= static_cast<double>(from.size());
  double dot = 0, cross = 0;
  for (size_t i = 0; i < from.size(); ++i) {
    const Eigen::Vector2d p = from[i] - mean_from, q = to[i] - mean_to;
    dot += p.dot(q);
    cross += p.x() * q.y() - p.y() * q.x();
  }
  RigidTransform mean;
  mean.heading = std::atan2(cross, dot);
  mean.translation = mean_to - Eigen::Rotation2Dd(mean.heading) * mean_from;
  return mean;
}

}  // namespace sbox
