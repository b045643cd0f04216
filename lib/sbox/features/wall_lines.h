// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Straight stretches of the outline of free space (section 3.1.1; contours instead of the Hough
// transform, as they tell which side of a wall is free).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sbox/features/free_contours.h"

namespace sbox {

/// A straight stretch; walking from `from` to `to`, free space is on the left. Grid frame, metres.
struct WallLine {
  Eigen::Vector2d from;   ///< Where it begins.
  Eigen::Vector2d to;     ///< Where it ends.
  double wall_share = 0;  ///< Share of its cells that lie at a wall; the rest border the unknown.

  /// Metres.
  [[nodiscard]] double length() const { return (to - from).norm(); }
  /// Unit vector from its begin to its end.
  [[nodiscard]] Eigen::Vector2d direction() const { return (to - from).normalized(); }
  /// Unit vector to the free side.
  [[nodiscard]] Eigen::Vector2d normal() const {
    const Eigen::Vector2d along = direction();
    return {-along.y(), along.x()};
  }
};

/// A point on a wall's face, in the grid frame, metres.
struct WallPoint {
  Eigen::Vector2d position;  ///< On the outline.
  Eigen::Vector2d normal;    ///< Unit vector to the free side.
  double line_length = 0;    ///< Of the line that it is on, metres; 0 off any line.
};

/// How outlines become lines and points.
struct WallLineOptions {
  double tolerance = 0.15;      ///< Of the Douglas-Peucker simplification, metres.
  double min_length = 0.5;      ///< Of a line, metres.
  double point_spacing = 0.2;   ///< Between wall points along an outline, metres.
  double tangent_reach = 0.35;  ///< Either side of a point that is on no line, metres.
};

/// What stands round the free space.
struct Walls {
  std::vector<WallLine> lines;    ///< Outline by outline.
  std::vector<WallPoint> points;  ///< Along all outlines, only where these lie at a wall.
};

/// Lines fitted to each outline by total least squares, and evenly spaced wall points, whose normal
/// is that of their line or, off any line, square to the outline's local direction. `resolution`:
/// of the contours' cells, metres.
[[nodiscard]] Walls findWalls(const std::vector<FreeContour>& contours, double resolution,
                              const WallLineOptions& options = {});

}  // namespace sbox
