// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points, lines and boxes in metres, painted into a plot with sub-pixel precision.
#pragma once

#include <array>
#include <opencv2/core.hpp>

#include "sbox/core/pose.h"
#include "sbox/core/state_grid.h"
#include "sbox/report/drawing/palette.h"
#include "sbox/report/drawing/plot_view.h"

namespace sbox {

/// The corners of a box in order, in metres.
using BoxCorners = std::array<Point2D, 4>;

/// The cells of a map alone: free white, walls in the given colour, the rest in the quiet grey.
[[nodiscard]] cv::Mat paintCells(const StateGrid& grid, const PlotView& view,
                                 const palette::Colour& wall);

/// A line, `width` pixels wide.
void paintLine(cv::Mat& plot, const PlotView& view, const Point2D& from, const Point2D& to,
               const palette::Colour& colour, int width);

/// A disc with a white rim.
void paintDot(cv::Mat& plot, const PlotView& view, const Point2D& centre,
              const palette::Colour& colour, int radius);

/// The four sides of a box, `width` pixels wide.
void paintBoxOutline(cv::Mat& plot, const PlotView& view, const BoxCorners& box,
                     const palette::Colour& colour, int width);

/// Sets the pixels inside the box, of a picture of any type.
void fillBox(cv::Mat& plot, const PlotView& view, const BoxCorners& box, const cv::Scalar& value);

/// Lets `share` of what was painted on `layer` through onto the plot: 0 nothing, 1 all.
void blend(cv::Mat& plot, const cv::Mat& layer, double share);

}  // namespace sbox
