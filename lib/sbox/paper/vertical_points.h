// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vertical points: where two perpendicular lines, or their extensions, meet (paper, section 3.1.1,
// eq. 1).
#pragma once

#include <vector>

#include "sbox/paper/hough_lines.h"

namespace sbox {

/// What counts as perpendicular.
struct VerticalPointOptions {
  double perpendicular_tolerance = M_PI / 60;  ///< Deviation from a right angle allowed, radians.
};

/// Eq. 1, p = (vx, vy, k1, b1, k2, b2): the point, and its two lines by their indices.
struct VerticalPoint {
  Point2D position;  ///< In the lines' frame, metres.
  int line1 = 0;     ///< The lower index.
  int line2 = 0;     ///< The higher index.
};

/// The vertical points of all pairs of perpendicular lines, in the order of (line1, line2).
[[nodiscard]] std::vector<VerticalPoint> findVerticalPoints(
    const std::vector<HoughLine>& lines, const VerticalPointOptions& options = {});

}  // namespace sbox
