// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Suppositional boxes (section 3.1.3, eq. 3): two lines along one axis against two along the other,
// real or extended.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sbox/features/axis_lines.h"
#include "sbox/features/wall_corners.h"

namespace sbox {

/// In the frame's axes, metres.
struct WallBox {
  std::array<Eigen::Vector2d, 4> corners;  ///< Counter-clockwise from the lower left.
  Eigen::Vector2d centre;                  ///< Mean of the corners.
  double size_x = 0;                       ///< Mean length of the sides along x.
  double size_y = 0;                       ///< Mean length of the sides along y.
  QuarterMask facing_in = 0;  ///< The sides (right, upper, left, lower) whose free side is inside.
  double cover = 0;           ///< Mean share of the sides that is real wall line.
};

/// Which boxes are kept.
struct BoxLimits {
  double min_side = 1.0;    ///< Metres.
  double max_side = 40.0;   ///< Metres.
  double min_cover = 0.1;   ///< Of each side.
  double mean_cover = 0.3;  ///< Of the four sides.
  int max_boxes = 1500;     ///< Those with the longest real sides are kept.
};

/// The suppositional boxes of one frame's lines (section 3.1.3): two lines along each axis,
/// extended where they do not reach, but real for a part of each side.
[[nodiscard]] std::vector<WallBox> findBoxes(const AxisLines& lines, const BoxLimits& limits = {});

}  // namespace sbox
