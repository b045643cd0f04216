// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/overlay_picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "sbox/report/drawing/figure.h"
#include "sbox/report/drawing/palette.h"
#include "sbox/report/drawing/plot_view.h"

namespace sbox {
namespace {

/// The plot is painted larger and shrunk, which makes its edges smooth.
constexpr int overlay_oversampling = 2;

}  // namespace

cv::Mat drawOverlay(const StateGrid& a, const StateGrid& b, const Pose2D& pose_b_in_a,
                    const std::string& title, const std::string& name_a, const std::string& name_b,
                    const OverlayOptions& options) {
  Bounds bounds;
  bounds.add(a, {});
  bounds.add(b, pose_b_in_a);
  const double scale = fitScale({bounds}, plot_long_side, std::min(a.resolution, b.resolution));
  const PlotView view = makeView(bounds, scale);
  const OverlayLayers layers =
      overlayLayers(a, b, pose_b_in_a, view, overlay_oversampling, options);

  cv::Mat canvas(layers.agreeing.size(), CV_8UC3, palette::scalar(palette::unknown));
  canvas.setTo(palette::scalar(palette::free_of_a), layers.a.free);
  canvas.setTo(palette::scalar(palette::free_of_b), layers.b.free);
  canvas.setTo(palette::scalar(palette::free_of_both), layers.a.free & layers.b.free);
  canvas.setTo(palette::scalar(palette::blue), layers.a.occupied);
  canvas.setTo(palette::scalar(palette::orange), layers.b.occupied);
  canvas.setTo(palette::scalar(palette::agreeing_wall), layers.agreeing);
  canvas.setTo(palette::scalar(palette::magenta), layers.conflicting);

  Figure figure;
  figure.title = title;
  figure.pixels_per_metre = scale;
  figure.plots.emplace_back();
  cv::resize(canvas, figure.plots[0], view.size, 0, 0, cv::INTER_AREA);
  cv::Mat small;
  cv::resize(layers.conflicting, small, view.size, 0, 0, cv::INTER_NEAREST);
  for (const cv::Point& centre : conflictCentres(small)) {
    cv::circle(figure.plots[0], centre, 13, palette::scalar(palette::magenta), 2, cv::LINE_AA);
  }
  figure.legend = {{Swatch::Line, palette::agreeing_wall, "wall in both"},
                   {Swatch::Line, palette::blue, "wall in " + name_a},
                   {Swatch::Line, palette::orange, "wall in " + name_b},
                   {Swatch::Area, palette::free_of_a, "free in " + name_a},
                   {Swatch::Area, palette::free_of_b, "free in " + name_b},
                   {Swatch::Area, palette::free_of_both, "free in both"},
                   {Swatch::Ring, palette::magenta, "wall of one in free space of the other"}};
  return composeFigure(figure);
}

}  // namespace sbox
