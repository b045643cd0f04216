// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells to pixels: what of a plot a map's cells cover, at any scale and angle.
#pragma once

#include <opencv2/core.hpp>

#include "sbox/core/state_grid.h"
#include "sbox/report/drawing/plot_view.h"

namespace sbox {

/// 255 where the plot shows such a cell, else 0 (8 bit, one channel, the view's size).
struct GridRaster {
  cv::Mat free;      ///< Free cells.
  cv::Mat occupied;  ///< Occupied cells.
};

/// The grid, whose map frame has the pose `pose_in_plot` in the plot's frame. Where a cell is
/// smaller than a pixel a pixel is occupied if any of its cells is, so that thin walls stay; walls
/// are drawn at least `min_wall_pixels` thick.
[[nodiscard]] GridRaster rasterize(const StateGrid& grid, const Pose2D& pose_in_plot,
                                   const PlotView& view, int min_wall_pixels);

}  // namespace sbox
