// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The features of a map in the paper's terms (section 3.1), whichever method found them: what
// reports count and pictures show.
#pragma once

#include <array>
#include <vector>

#include "sbox/core/pose.h"

namespace sbox {

/// A wall line, by the two ends of what is seen of it, in the map frame.
struct LineSegment {
  Point2D from;  ///< One end.
  Point2D to;    ///< The other.
};

/// Lines (3.1.1), vertical points (eq. 1) and suppositional boxes (eq. 3) in the map frame, metres.
struct FeatureSet {
  std::vector<LineSegment> lines;             ///< Section 3.1.1.
  std::vector<Point2D> vertical_points;       ///< Eq. 1.
  std::vector<std::array<Point2D, 4>> boxes;  ///< Corners, counter-clockwise.
};

}  // namespace sbox
