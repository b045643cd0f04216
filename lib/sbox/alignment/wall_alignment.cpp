// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/alignment/wall_alignment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sbox/alignment/robust_kernel.h"
#include "sbox/alignment/wall_pairs.h"

namespace sbox {
namespace {

/// Normal equations of the step (dx, dy, dheading about the pivot), in the frame of map a.
struct Normals {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();

  /// `point` should move to the line through `target` with this normal; `arm` is its place about
  /// the pivot.
  void add(const Eigen::Vector2d& offset, const Eigen::Vector2d& normal, const Eigen::Vector2d& arm,
           double kernel, double length) {
    const double residual = normal.dot(offset);
    const double share = gemanMcClureShare(offset.squaredNorm(), kernel);
    const Eigen::Vector3d jacobian(normal.x(), normal.y(),
                                   normal.y() * arm.x() - normal.x() * arm.y());
    const double weight = length * share * share;
    matrix += weight * jacobian * jacobian.transpose();
    vector += weight * residual * jacobian;
  }
};

/// The walls of each map against those of the other; each wall counts half from either side.
Normals gatherNormals(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
                      const Eigen::Vector2d& pivot, const AlignmentOptions& options) {
  const PointMover to_a(b_in_a);
  Normals normals;
  const double length_b =
      b.wallLengthPerPoint(std::min(options.most_points, b.wall_points.size())) / 2;
  const double length_a =
      a.wallLengthPerPoint(std::min(options.most_points, a.wall_points.size())) / 2;
  forEachWallPair(
      a, b, b_in_a, options.most_points,
      [&](const WallPoint&, const Eigen::Vector2d& p, const WallPoint& target) {
        normals.add(target.position - p, target.normal, p - pivot, options.kernel, length_b);
      },
      [&](const WallPoint& point, const Eigen::Vector2d&, const WallPoint& source) {
        // The wall of b is what moves.
        const Eigen::Vector2d moved = to_a(source.position);
        normals.add(point.position - moved, to_a.turn(source.normal), moved - pivot, options.kernel,
                    length_a);
      });
  return normals;
}

}  // namespace

RigidTransform alignWalls(const MapFeatures& a, const MapFeatures& b, const RigidTransform& start,
                          const AlignmentOptions& options) {
  RigidTransform b_in_a = start;
  const Eigen::Vector2d centre_b = b.middle();
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const Eigen::Vector2d pivot = b_in_a * centre_b;
    Normals normals = gatherNormals(a, b, b_in_a, pivot, options);
    // As of a millimetre of wall: keeps what nothing fixes where it was.
    normals.matrix.diagonal() += Eigen::Vector3d(1e-3, 1e-3, 1e-2);
    const Eigen::Vector3d step = normals.matrix.inverse() * normals.vector;
    b_in_a.heading += step.z();
    b_in_a.translation = pivot + step.head<2>() - Eigen::Rotation2Dd(b_in_a.heading) * centre_b;
    constexpr double small_shift = 0.005, small_turn = 0.0005;  // Metres; radians.
    if (step.head<2>().norm() < small_shift && std::abs(step.z()) < small_turn) {
      break;
    }
  }
  return b_in_a;
}

Eigen::Matrix3d wallInformation(const MapFeatures& a, const MapFeatures& b,
                                const RigidTransform& b_in_a, const AlignmentOptions& options) {
  const Eigen::Vector2d centre_b = b.middle();
  return gatherNormals(a, b, b_in_a, b_in_a * centre_b, options).matrix;
}

}  // namespace sbox
