// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Right-angled corners: the vertical points of section 3.1.1 (eq. 1), told apart by the sides that
// are free and by the arms that exist.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sbox/features/axis_lines.h"

namespace sbox {

/// One bit for each quarter of a frame.
using QuarterMask = std::uint8_t;

/// The mask of a thing turned by `turns` quarter turns counter-clockwise.
[[nodiscard]] QuarterMask turned(QuarterMask mask, int turns);

/// Where two perpendicular lines meet, or would. In the frame's axes, metres.
struct WallCorner {
  Eigen::Vector2d position;    ///< Where the two lines meet.
  QuarterMask free_sides = 0;  ///< The side each of the two lines faces.
  QuarterMask arms = 0;        ///< The directions in which a line runs from here.
  double strength = 0;         ///< Length of the shorter line's arm, metres.
};

/// Which corners are kept.
struct CornerOptions {
  double reach = 3.0;    ///< Both lines come this near to the corner, metres.
  double min_arm = 0.4;  ///< A line that goes less far beyond the corner has no arm there, metres.
  int max_corners = 1500;  ///< The strongest are kept.
};

/// The right angles that one frame's lines form where they meet or nearly do.
[[nodiscard]] std::vector<WallCorner> findCorners(const AxisLines& lines,
                                                  const CornerOptions& options = {});

/// Where a line along x and a line along y meet; in the frame's axes, metres.
[[nodiscard]] Eigen::Vector2d crossing(const AxisLine& along_x, const AxisLine& along_y);

}  // namespace sbox
