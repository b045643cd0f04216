// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lines of one frame: those that run along either of its axes, sorted by the side they face,
// stretches of one wall joined across its doors.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sbox/features/wall_frames.h"
#include "sbox/features/wall_lines.h"

namespace sbox {

/// A direction of a frame in quarter turns from its x axis: 0 +x, 1 +y, 2 -x, 3 -y.
using Quarter = int;

/// A line of a frame, in the frame's axes (the grid frame turned about its origin), metres. It may
/// be off its axis by some degrees, as drifted maps are bent.
struct AxisLine {
  double low = 0;         ///< Least coordinate along the line's axis.
  double high = 0;        ///< Largest coordinate along it.
  double across = 0;      ///< Coordinate on the other axis at the middle.
  double slope = 0;       ///< Change of `across` a metre along.
  double wall_share = 0;  ///< Share that lies at a wall.

  /// Coordinate on the other axis at the place `along`.
  [[nodiscard]] double acrossAt(double along) const {
    return across + slope * (along - 0.5 * (low + high));
  }
  /// Share of [from, to] that the line covers.
  [[nodiscard]] double cover(double from, double to) const;
};

/// What counts as a line of a frame.
struct AxisLineOptions {
  double max_tilt = 20;         ///< Off the axis, degrees.
  double join_gap = 2.5;        ///< Stretches of a wall this far apart are one line, metres.
  double join_offset = 0.3;     ///< Distance across at which they still are, metres.
  double min_wall_share = 0.3;  ///< A line that lies less at walls is an edge of the unknown.
};

/// Lines by the side they face. Lines facing +x or -x run along y.
using AxisLines = std::array<std::vector<AxisLine>, 4>;

/// How far lines run off their axes: root mean square slope, weighed by squared length, of those at
/// least `min_length` metres long. It tells how much a map is bent in itself. 0 without lines.
[[nodiscard]] double slopeSpread(const AxisLines& lines, double min_length = 2.0);

/// The lines of the frame, each side's in ascending order of `across`.
[[nodiscard]] AxisLines linesOfFrame(const std::vector<WallLine>& lines, const WallFrame& frame,
                                     const AxisLineOptions& options = {});

}  // namespace sbox
