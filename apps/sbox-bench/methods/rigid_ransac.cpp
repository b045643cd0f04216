// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/methods/rigid_ransac.h"

#include <cmath>
#include <random>

#include "sbox/core/rigid_fit.h"

namespace sbox::bench {
namespace {

constexpr int kRefits = 5;

std::vector<int> agreeing(const std::vector<PointMatch>& matches, const Pose2D& pose_b_in_a,
                          double tolerance) {
  const double c = std::cos(pose_b_in_a.phi), s = std::sin(pose_b_in_a.phi);
  std::vector<int> indices;
  for (size_t i = 0; i < matches.size(); ++i) {
    const PointMatch& m = matches[i];
    const double dx = pose_b_in_a.x + c * m.in_b.x - s * m.in_b.y - m.in_a.x;
    const double dy = pose_b_in_a.y + s * m.in_b.x + c * m.in_b.y - m.in_a.y;
    if (dx * dx + dy * dy <= tolerance * tolerance) {
      indices.push_back(static_cast<int>(i));
    }
  }
  return indices;
}

Pose2D fitOf(const std::vector<PointMatch>& matches, const std::vector<int>& indices) {
  std::vector<Point2D> from, to;
  for (const int i : indices) {
    const PointMatch& m = matches[static_cast<size_t>(i)];
    from.push_back(m.in_b);
    to.push_back(m.in_a);
  }
  return fitRigid(from, to);
}

}  // namespace

RansacResult rigidRansac(const std::vector<PointMatch>& matches, const RansacOptions& options) {
  RansacResult best;
  if (matches.size() < 2) {
    return best;
  }
  std::mt19937 random(options.seed);
  const auto draw = [&] { return static_cast<int>(random() % matches.size()); };
  for (int i = 0; i < options.draws; ++i) {
    const int first = draw(), second = draw();
    const PointMatch& p = matches[static_cast<size_t>(first)];
    const PointMatch& q = matches[static_cast<size_t>(second)];
    const double length_a = std::hypot(p.in_a.x - q.in_a.x, p.in_a.y - q.in_a.y);
    const double length_b = std::hypot(p.in_b.x - q.in_b.x, p.in_b.y - q.in_b.y);
    if (length_a < options.least_length || length_b < options.least_length ||
        std::abs(length_a - length_b) > 2 * options.tolerance) {
      continue;
    }
    const Pose2D pose = fitOf(matches, {first, second});
    std::vector<int> inliers = agreeing(matches, pose, options.tolerance);
    if (inliers.size() > best.inliers.size()) {
      best = {pose, std::move(inliers)};
    }
  }
  for (int i = 0; i < kRefits && best.inliers.size() >= 2; ++i) {
    best.pose_b_in_a = fitOf(matches, best.inliers);
    best.inliers = agreeing(matches, best.pose_b_in_a, options.tolerance);
  }
  return best;
}

}  // namespace sbox::bench
