// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace sbox {

/// A rigid transform between the grid frames of two maps: p_a = R(heading) p_b + translation.
/// Proper by construction: a mirror image is never an answer.
struct RigidTransform {
  double heading = 0;                                     ///< Radians.
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();  ///< Metres.

  /// The point in the grid frame of map a.
  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& point_b) const {
    return Eigen::Rotation2Dd(heading) * point_b + translation;
  }
  /// The transform from map a to map b.
  [[nodiscard]] RigidTransform inverse() const {
    return {-heading, -(Eigen::Rotation2Dd(-heading) * translation)};
  }
};

/// A transform with its sine and cosine at hand, to move many points.
struct PointMover {
  double c;  ///< Cosine of the heading.
  double s;  ///< Its sine.
  double x;  ///< Translation, metres.
  double y;  ///< Translation, metres.

  /// From the transform.
  explicit PointMover(const RigidTransform& transform)
      : c(std::cos(transform.heading)),
        s(std::sin(transform.heading)),
        x(transform.translation.x()),
        y(transform.translation.y()) {}
  /// The point moved.
  [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector2d& p) const {
    return {c * p.x() - s * p.y() + x, s * p.x() + c * p.y() + y};
  }
  /// The direction turned.
  [[nodiscard]] Eigen::Vector2d turn(const Eigen::Vector2d& d) const {
    return {c * d.x() - s * d.y(), s * d.x() + c * d.y()};
  }
};

}  // namespace sbox
