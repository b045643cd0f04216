// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One wall gives several nearly equal lines, so one real corner gives a cloud of vertical points:
// each cloud becomes one point (paper, section 3.1.2, eq. 2).
#pragma once

#include <vector>

#include "sbox/paper/vertical_points.h"

namespace sbox {

/// Which points are one corner.
struct ClusterOptions {
  double radius = 0.5;      ///< A point within this of a cluster's first member joins it, metres.
  double precision = 1e-8;  ///< Newton's method ends when its step is shorter, metres.
};

/// The vertical points that are taken for one corner.
struct PointCluster {
  Point2D position;          ///< The point with the least sum of squared distances (eq. 2).
  std::vector<int> members;  ///< Indices of the vertical points, ascending.
};

/// Eq. 2 by Newton's method from the first point. Throws std::invalid_argument without points or
/// with a precision that is not positive.
[[nodiscard]] Point2D leastSquaresPoint(const std::vector<Point2D>& points,
                                        double precision = 1e-8);

/// Clusters in the order of their first members. The paper names no clustering: here each point, in
/// order, joins the nearest cluster whose first member lies within the radius, or founds one. As
/// the strongest lines come first, clusters form round the best supported points and cannot chain.
[[nodiscard]] std::vector<PointCluster> clusterPoints(const std::vector<VerticalPoint>& points,
                                                      const ClusterOptions& options = {});

}  // namespace sbox
