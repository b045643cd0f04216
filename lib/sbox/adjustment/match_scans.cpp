// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/adjustment/match_scans.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace sbox {
namespace {

/// Normal equations of the distances from points to lines, by (x, y, heading) of b in a.
struct Equations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  int matches = 0;
};

/// The nearest point of a surface that faces the same way; null where none is within the gate.
const ScanPoint* nearest(const std::vector<ScanPoint>& points, const ScanPoint& to, double gate,
                         double least_cosine) {
  const ScanPoint* best = nullptr;
  double best_squared = gate * gate;
  for (const ScanPoint& point : points) {
    const double squared = (point.place - to.place).squaredNorm();
    if (squared < best_squared && point.normal.dot(to.normal) > least_cosine) {
      best_squared = squared;
      best = &point;
    }
  }
  return best;
}

Equations equationsAt(const Pose2D& b_in_a, const std::vector<ScanPoint>& a,
                      const std::vector<ScanPoint>& b, double gate,
                      const ScanMatchOptions& options) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(b_in_a.phi).toRotationMatrix();
  const Eigen::Vector2d shift(b_in_a.x, b_in_a.y);
  const double least_cosine = std::cos(options.most_turn);
  Equations equations;
  for (const ScanPoint& point : b) {
    const Eigen::Vector2d arm = turn * point.place;
    const ScanPoint in_a{shift + arm, turn * point.normal};
    const ScanPoint* line = nearest(a, in_a, gate, least_cosine);
    if (line == nullptr) {
      continue;
    }
    const double off = line->normal.dot(in_a.place - line->place);
    const Eigen::Vector3d by_pose(line->normal.x(), line->normal.y(),
                                  line->normal.dot(Eigen::Vector2d(-arm.y(), arm.x())));
    const double ratio = off / options.kernel;
    const double weight = 1 / ((1 + ratio * ratio) * (1 + ratio * ratio));
    equations.information += weight * by_pose * by_pose.transpose();
    equations.gradient += weight * off * by_pose;
    ++equations.matches;
  }
  return equations;
}

/// What holds the pose where no surface does.
Eigen::Matrix3d damping() { return Eigen::Vector3d(1, 1, 10).asDiagonal(); }

PoseCovariance covarianceOf(const Eigen::Matrix3d& information, double noise) {
  constexpr double floor_metres = 0.01, floor_radians = 0.003;
  constexpr double loose_metres = 1, loose_radians = 0.2;
  const Eigen::Matrix3d loose =
      Eigen::Vector3d(1 / (loose_metres * loose_metres), 1 / (loose_metres * loose_metres),
                      1 / (loose_radians * loose_radians))
          .asDiagonal();
  const Eigen::Matrix3d least =
      Eigen::Vector3d(floor_metres * floor_metres, floor_metres * floor_metres,
                      floor_radians * floor_radians)
          .asDiagonal();
  const Eigen::Matrix3d all = information / (noise * noise) + loose;
  const PoseCovariance covariance = all.inverse() + least;
  return (covariance + covariance.transpose()) / 2;
}

}  // namespace

std::optional<ScanMatch> matchScans(const std::vector<ScanPoint>& a,
                                    const std::vector<ScanPoint>& b, const Pose2D& start,
                                    const ScanMatchOptions& options) {
  if (a.empty() || b.empty()) {
    return std::nullopt;
  }
  Pose2D pose = start;
  for (int i = 0; i < options.iterations; ++i) {
    const double gate = i < options.iterations / 2 ? options.gate : options.last_gate;
    const Equations equations = equationsAt(pose, a, b, gate, options);
    const Eigen::Vector3d step =
        -(equations.information + damping()).inverse() * equations.gradient;
    pose = {pose.x + step.x(), pose.y + step.y(), wrapAngle(pose.phi + step.z())};
  }
  const Equations equations = equationsAt(pose, a, b, options.last_gate, options);
  const double overlap = equations.matches / static_cast<double>(std::min(a.size(), b.size()));
  if (overlap < options.least_overlap ||
      std::hypot(pose.x - start.x, pose.y - start.y) > options.most_shift ||
      std::abs(wrapAngle(pose.phi - start.phi)) > options.most_rotation) {
    return std::nullopt;
  }
  return ScanMatch{pose, covarianceOf(equations.information, options.noise),
                   std::min(1.0, overlap)};
}

}  // namespace sbox
