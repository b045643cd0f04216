// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which part of the plane a plot shows, and how large: metres to pixels.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "sbox/core/pose.h"
#include "sbox/core/state_grid.h"

namespace sbox {

/// An axis-aligned part of the plane, in metres.
struct Bounds {
  Point2D low{0, 0};   ///< Lower-left corner.
  Point2D high{0, 0};  ///< Upper-right corner.
  bool empty = true;   ///< Nothing was included yet.

  /// Grows to hold the point.
  void add(const Point2D& point);
  /// Grows to hold what the grid knows, whose map frame has the pose `pose_in_plot` in the plot's
  /// frame, but for stray specks: at each side up to 1 in 1000 known cells may be left out.
  void add(const StateGrid& grid, const Pose2D& pose_in_plot);
};

/// Metres of the plot's frame to pixels; y up becomes y down.
struct PlotView {
  Point2D low;                  ///< Lower-left corner of the plot, in metres.
  double pixels_per_metre = 1;  ///< The scale.
  cv::Size size;                ///< Of the plot, in pixels.

  /// The point in pixels; whole numbers are pixel corners.
  [[nodiscard]] cv::Point2d toPixels(const Point2D& point) const;
  /// The same view in a picture `factor` times as large.
  [[nodiscard]] PlotView enlarged(int factor) const;
};

/// Pixels a metre takes when plots of these extents (metres) share one scale and the longer side of
/// the largest comes to `long_side` pixels, but a cell of `resolution` metres to no more than 40.
[[nodiscard]] double fitScale(const std::vector<Bounds>& plots, int long_side, double resolution);

/// A view of the bounds with a margin of a fiftieth of the longer side all round.
[[nodiscard]] PlotView makeView(const Bounds& bounds, double pixels_per_metre);

}  // namespace sbox
