// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/rigid_fit.h"

#include <cmath>
#include <stdexcept>

namespace sbox {
namespace {

Point2D meanOf(const std::vector<Point2D>& points) {
  const auto count = static_cast<double>(points.size());
  Point2D sum(0, 0);
  for (const Point2D& point : points) {
    sum += point;
  }
  return {sum.x / count, sum.y / count};
}

}  // namespace

Pose2D fitRigid(const std::vector<Point2D>& from, const std::vector<Point2D>& to) {
  if (from.empty() || from.size() != to.size()) {
    throw std::invalid_argument(
        "a rigid fit needs as many points on either side, and one at least");
  }
  const Point2D from_mean = meanOf(from), to_mean = meanOf(to);
  double dot = 0, cross = 0;
  for (size_t i = 0; i < from.size(); ++i) {
    const Point2D p = from[i] - from_mean, q = to[i] - to_mean;
    dot += p.x * q.x + p.y * q.y;
    cross += p.x * q.y - p.y * q.x;
  }
  const double phi = std::atan2(cross, dot);
  const double c = std::cos(phi), s = std::sin(phi);
  return {to_mean.x - (c * from_mean.x - s * from_mean.y),
          to_mean.y - (s * from_mean.x + c * from_mean.y), phi};
}

}  // namespace sbox
