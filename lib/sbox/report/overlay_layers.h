// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two maps over each other, pixel by pixel: where they agree, and where a wall of one stands in
// free space of the other.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "sbox/core/pose.h"
#include "sbox/core/state_grid.h"
#include "sbox/report/drawing/grid_raster.h"
#include "sbox/report/drawing/plot_view.h"

namespace sbox {

/// How overlays are drawn.
struct OverlayOptions {
  double agree_within = 0.2;    ///< Walls this near to each other agree, in metres.
  double conflict_depth = 0.3;  ///< A wall this deep in the other's free space conflicts, metres.
};

/// 255 where it holds, else 0 (8 bit, one channel).
struct OverlayLayers {
  GridRaster a;         ///< What map a covers.
  GridRaster b;         ///< What map b covers.
  cv::Mat agreeing;     ///< Walls of one that have walls of the other close by.
  cv::Mat conflicting;  ///< Walls of one deep in free space of the other.
};

/// What a view of a's frame shows of map a and of map b, whose frame has the pose `pose_b_in_a`
/// there. The layers are `oversampling` times as large as the view; walls are at least 2 pixels of
/// the view thick.
[[nodiscard]] OverlayLayers overlayLayers(const StateGrid& a, const StateGrid& b,
                                          const Pose2D& pose_b_in_a, const PlotView& view,
                                          int oversampling, const OverlayOptions& options = {});

/// Pixels where conflicting wall gathers, at most one in each square of a coarse raster.
[[nodiscard]] std::vector<cv::Point> conflictCentres(const cv::Mat& conflicting);

}  // namespace sbox
