// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/point_clusters.h"

#include <cmath>
#include <stdexcept>

namespace sbox {

Point2D leastSquaresPoint(const std::vector<Point2D>& points, double precision) {
  if (points.empty() || !(precision > 0)) {
    throw std::invalid_argument("eq. 2 needs a point and a positive precision");
  }
  const auto count = static_cast<double>(points.size());
  Point2D best = points.front();
  for (double step = precision; step >= precision;) {
    // f = sum |p - best|^2: gradient -2 sum (p - best), Hessian 2 n I.
    Point2D gradient(0, 0);
    for (const Point2D& p : points) {
      gradient.x -= 2 * (p.x - best.x);
      gradient.y -= 2 * (p.y - best.y);
    }
    const Point2D move(-gradient.x / (2 * count), -gradient.y / (2 * count));
    best.x += move.x;
    best.y += move.y;
    step = std::hypot(move.x, move.y);
  }
  return best;
}

std::vector<PointCluster> clusterPoints(const std::vector<VerticalPoint>& points,
                                        const ClusterOptions& options) {
  std::vector<PointCluster> clusters;
  for (size_t i = 0; i < points.size(); ++i) {
    PointCluster* nearest = nullptr;
    double nearest_distance = options.radius;
    for (PointCluster& cluster : clusters) {
      const Point2D& first = points[static_cast<size_t>(cluster.members.front())].position;
      const double distance =
          std::hypot(points[i].position.x - first.x, points[i].position.y - first.y);
      if (distance <= nearest_distance) {
        nearest_distance = distance;
        nearest = &cluster;
      }
    }
    if (nearest == nullptr) {
      nearest = &clusters.emplace_back();
    }
    nearest->members.push_back(static_cast<int>(i));
  }
  for (PointCluster& cluster : clusters) {
    std::vector<Point2D> members;
    members.reserve(cluster.members.size());
    for (const int i : cluster.members) {
      members.push_back(points[static_cast<size_t>(i)].position);
    }
    cluster.position = leastSquaresPoint(members, options.precision);
  }
  return clusters;
}

}  // namespace sbox
