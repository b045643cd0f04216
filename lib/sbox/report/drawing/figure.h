// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What every picture has in common: one or more plots side by side at one scale, a title line above
// them, a legend and a scale bar below.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "sbox/report/drawing/palette.h"

namespace sbox {

/// The samples that a legend can show.
enum class Swatch { Area, Line, Dot, Box, Ring };

/// A line of the legend: what is drawn so means this.
struct LegendEntry {
  Swatch swatch = Swatch::Area;  ///< How the sample is drawn.
  palette::Colour colour;        ///< Of the sample.
  std::string text;              ///< What it means.
};

/// Plots and what stands round them.
struct Figure {
  std::string title;                  ///< One line above the plots.
  std::vector<cv::Mat> plots;         ///< 8 bit, three channels, drawn at one scale.
  std::vector<std::string> captions;  ///< Under the plots; none or one for each.
  double pixels_per_metre = 1;        ///< Of all plots.
  std::vector<LegendEntry> legend;    ///< Below the plots, wrapped to their width.
};

/// The longer side of the plots that a figure is laid out for, in pixels; the whole stays within
/// 2000 x 2000.
inline constexpr int plot_long_side = 1500;

/// The whole picture.
[[nodiscard]] cv::Mat composeFigure(const Figure& figure);

/// The picture as the bytes of a PNG file.
[[nodiscard]] std::vector<unsigned char> encodePng(const cv::Mat& picture);

}  // namespace sbox
