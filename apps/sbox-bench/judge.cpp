// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/judge.h"

#include <algorithm>
#include <cmath>

namespace sbox::bench {
namespace {

constexpr double kRotationToleranceDeg = 5;

double angleBetweenDeg(double a, double b) { return std::abs(std::remainder(a - b, 360.0)); }

}  // namespace

const char* toString(Outcome outcome) {
  switch (outcome) {
    case Outcome::Right:
      return "right";
    case Outcome::Wrong:
      return "wrong";
    case Outcome::Refused:
      break;
  }
  return "refused";
}

std::optional<PoseError> poseError(const AnnotatedPair& pair, double resolution,
                                   const Pose2D& corner_a_in_corner_b) {
  if (pair.negative) {
    return std::nullopt;
  }
  Pose2D in_cells = corner_a_in_corner_b;
  in_cells.x /= resolution;
  in_cells.y /= resolution;
  double sum = 0;
  for (size_t i = 0; i < pair.points_a.size(); ++i) {
    const Point2D placed = in_cells.composePoint(pair.points_a[i]);
    sum += std::pow(placed.x - pair.points_b[i].x, 2) + std::pow(placed.y - pair.points_b[i].y, 2);
  }
  const double rms = std::sqrt(sum / static_cast<double>(pair.points_a.size()));
  const double theta_deg = corner_a_in_corner_b.phi * 180 / M_PI;
  PoseError error;
  error.excess_cells = rms - pair.floor_cells;
  error.rotation_deg = angleBetweenDeg(theta_deg, pair.theta_deg);
  if (pair.theta_local) {
    error.rotation_deg =
        std::min(error.rotation_deg, angleBetweenDeg(theta_deg, *pair.theta_local));
  }
  error.right =
      rms <= pair.floor_cells + pair.tolerance_cells && error.rotation_deg <= kRotationToleranceDeg;
  return error;
}

Outcome judge(const AnnotatedPair& pair, bool accepted, const std::optional<PoseError>& error) {
  if (pair.negative) {
    return accepted ? Outcome::Wrong : Outcome::Right;
  }
  if (!accepted) {
    return Outcome::Refused;
  }
  return error && error->right ? Outcome::Right : Outcome::Wrong;
}

Pose2D cornerTransform(const Pose2D& pose_b_in_a, const Pose2D& corner_in_a,
                       const Pose2D& corner_in_b) {
  return inverse(corner_in_b) + (inverse(pose_b_in_a) + corner_in_a);
}

Pose2D poseFromCorners(const Pose2D& corner_a_in_corner_b, const Pose2D& corner_in_a,
                       const Pose2D& corner_in_b) {
  return corner_in_a + (inverse(corner_a_in_corner_b) + inverse(corner_in_b));
}

}  // namespace sbox::bench
