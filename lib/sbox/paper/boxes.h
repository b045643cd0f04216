// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Suppositional boxes: four vertical points that pairwise share lines and close a loop (paper,
// section 3.1.3, eq. 3, Algorithm 1).
#pragma once

#include <array>
#include <vector>

#include "sbox/paper/point_clusters.h"

namespace sbox {

/// Limits on boxes.
struct BoxOptions {
  double min_width = 1.0;    ///< The shorter side is at least this long, metres.
  double max_height = 60.0;  ///< The longer side is at most this long, metres.
  int max_boxes = 1500;      ///< The largest by area are kept.
};

/// Eq. 3, R = (z1..z4, height, width, area, cx, cy), metres.
struct SuppositionalBox {
  std::array<Point2D, 4> corners;  ///< Counter-clockwise from the lower left (least x + y).
  double height = 0;               ///< The longer side.
  double width = 0;                ///< The shorter side.
  double area = 0;                 ///< Square metres.
  Point2D centre;                  ///< Mean of the corners.
};

/// Eq. 3 of four corners that go round a convex quadrangle, either way.
[[nodiscard]] SuppositionalBox describeBox(const std::array<Point2D, 4>& loop);

/// All boxes within the limits, largest first. `clusters` refer to `points`, and these to lines.
/// Algorithm 1 walks from point to point along shared lines; a box is thereby two lines crossed by
/// two others with a vertical point at each of the four crossings, which is how they are found
/// here. A corner is the place of its point's cluster; loops through the same four clusters are one
/// box.
[[nodiscard]] std::vector<SuppositionalBox> buildBoxes(const std::vector<VerticalPoint>& points,
                                                       const std::vector<PointCluster>& clusters,
                                                       const BoxOptions& options = {});

}  // namespace sbox
