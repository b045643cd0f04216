// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/features_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sbox/report/drawing/figure.h"
#include "sbox/report/drawing/paint.h"
#include "sbox/report/words.h"

namespace sbox {
namespace {

/// How many boxes cover each pixel, at most 255.
cv::Mat coverDepth(const PlotView& view, const std::vector<BoxCorners>& boxes) {
  cv::Mat depth(view.size, CV_8U, cv::Scalar(0));
  cv::Mat mask(view.size, CV_8U, cv::Scalar(0));
  const cv::Rect whole({0, 0}, view.size);
  for (const BoxCorners& box : boxes) {
    Bounds bounds;
    for (const Point2D& corner : box) {
      bounds.add(corner);
    }
    const cv::Rect covered =
        cv::Rect(view.toPixels({bounds.low.x, bounds.high.y}),
                 view.toPixels({bounds.high.x, bounds.low.y}) + cv::Point2d(2, 2)) &
        whole;
    if (covered.empty()) {
      continue;
    }
    mask(covered).setTo(0);
    fillBox(mask, view, box, cv::Scalar(1));
    depth(covered) += mask(covered);
  }
  return depth;
}

/// A tint that deepens where more boxes lie over each other and never hides the cells.
void paintDepth(cv::Mat& plot, const cv::Mat& depth, const palette::Colour& colour) {
  constexpr double one_box = 0.1, most_boxes = 0.5;
  double deepest = 1;
  cv::minMaxLoc(depth, nullptr, &deepest);
  std::array<double, 256> shares{};
  for (size_t boxes = 1; boxes < shares.size(); ++boxes) {
    const double part = static_cast<double>(boxes - 1) / std::max(deepest - 1, 1.0);
    shares[boxes] = one_box + (most_boxes - one_box) * std::min(part, 1.0);
  }
  for (int y = 0; y < plot.rows; ++y) {
    auto* pixel = plot.ptr<cv::Vec3b>(y);
    const auto* layers = depth.ptr<unsigned char>(y);
    for (int x = 0; x < plot.cols; ++x, ++pixel, ++layers) {
      for (int channel = 0; channel < 3; ++channel) {
        const double blended =
            (*pixel)[channel] + shares[*layers] * (colour[channel] - (*pixel)[channel]);
        (*pixel)[channel] = cv::saturate_cast<unsigned char>(blended);
      }
    }
  }
}

}  // namespace

cv::Mat drawFeatures(const StateGrid& grid, const FeatureSet& features, const std::string& name) {
  Bounds bounds;
  bounds.add(grid, {});
  const double scale = fitScale({bounds}, plot_long_side, grid.resolution);
  const PlotView view = makeView(bounds, scale);
  cv::Mat plot = paintCells(grid, view, palette::soft_wall);

  const auto box_count = static_cast<int>(features.boxes.size());
  if (box_count > 0) {
    paintDepth(plot, coverDepth(view, features.boxes), palette::blue);
    cv::Mat outlines = plot.clone();
    for (const BoxCorners& box : features.boxes) {
      paintBoxOutline(outlines, view, box, palette::blue, 1);
    }
    blend(plot, outlines, std::clamp(4 / std::sqrt(box_count), 0.2, 0.7));
  }
  for (const LineSegment& line : features.lines) {
    paintLine(plot, view, line.from, line.to, palette::green, 2);
  }
  for (const Point2D& point : features.vertical_points) {
    paintDot(plot, view, point, palette::vermillion, 5);
  }

  Figure figure;
  figure.title = name + ": the features found";
  figure.plots = {plot};
  figure.pixels_per_metre = scale;
  figure.legend = {{Swatch::Line, palette::green, counted(features.lines.size(), "line", "lines")},
                   {Swatch::Dot, palette::vermillion,
                    counted(features.vertical_points.size(), "vertical point", "vertical points")},
                   {Swatch::Box, palette::blue,
                    counted(features.boxes.size(), "suppositional box", "suppositional boxes")},
                   {Swatch::Area, palette::soft_wall, "wall"},
                   {Swatch::Area, palette::unknown, "unknown"}};
  return composeFigure(figure);
}

}  // namespace sbox
