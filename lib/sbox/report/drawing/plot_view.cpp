// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/drawing/plot_view.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sbox {

void Bounds::add(const Point2D& point) {
  if (empty) {
    low = high = point;
    empty = false;
    return;
  }
  low = {std::min(low.x, point.x), std::min(low.y, point.y)};
  high = {std::max(high.x, point.x), std::max(high.y, point.y)};
}

void Bounds::add(const StateGrid& grid, const Pose2D& pose_in_plot) {
  if (grid.empty()) {
    return;
  }
  const double w = grid.width * grid.resolution, h = grid.height * grid.resolution;
  const Pose2D corner_in_plot = pose_in_plot + grid.corner_in_map;
  for (const Point2D& corner : std::array<Point2D, 4>{{{0, 0}, {w, 0}, {w, h}, {0, h}}}) {
    add(corner_in_plot.composePoint(corner));
  }
}

cv::Point2d PlotView::toPixels(const Point2D& point) const {
  return {(point.x - low.x) * pixels_per_metre, size.height - (point.y - low.y) * pixels_per_metre};
}

PlotView PlotView::enlarged(int factor) const {
  return {low, pixels_per_metre * factor, size * factor};
}

double fitScale(const std::vector<Bounds>& plots, int long_side, double resolution) {
  constexpr double max_pixels_per_cell = 40;
  double longest = resolution;
  for (const Bounds& plot : plots) {
    longest = std::max({longest, plot.high.x - plot.low.x, plot.high.y - plot.low.y});
  }
  return std::min(long_side / longest, max_pixels_per_cell / resolution);
}

PlotView makeView(const Bounds& bounds, double pixels_per_metre) {
  const double margin =
      std::max({bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y, 0.5}) / 50;
  PlotView view;
  view.low = {bounds.low.x - margin, bounds.low.y - margin};
  view.pixels_per_metre = pixels_per_metre;
  const auto pixels = [&](double metres) {
    return std::max(1, static_cast<int>(std::ceil((metres + 2 * margin) * pixels_per_metre)));
  };
  view.size = {pixels(bounds.high.x - bounds.low.x), pixels(bounds.high.y - bounds.low.y)};
  return view;
}

}  // namespace sbox
