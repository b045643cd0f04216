// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/drawing/plot_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sbox {
namespace {

/// How many cells lie in each strip, a cell wide, across one axis of the plot.
class StripCounts {
 public:
  /// A step along a row and one up a column move by so much along the axis, in cells.
  StripCounts(double per_column, double per_row, const StateGrid& grid)
      : per_column_(per_column), per_row_(per_row) {
    const double by_columns = per_column * (grid.width - 1), by_rows = per_row * (grid.height - 1);
    first_ = std::floor(std::min(by_columns, 0.0) + std::min(by_rows, 0.0));
    const double last = std::ceil(std::max(by_columns, 0.0) + std::max(by_rows, 0.0));
    counts_.assign(static_cast<size_t>(last - first_) + 2, 0);
  }
  void add(int column, int row) {
    ++counts_[static_cast<size_t>(std::lround(per_column_ * column + per_row_ * row - first_))];
  }
  /// Low end of the first and high end of the last strip between which all but `spare` of the cells
  /// at each end lie.
  [[nodiscard]] std::pair<double, double> mainSpan(int spare) const {
    size_t first = 0, last = counts_.size() - 1;
    for (int left_out = 0; first < last && (left_out += counts_[first]) <= spare;) {
      ++first;
    }
    for (int left_out = 0; first < last && (left_out += counts_[last]) <= spare;) {
      --last;
    }
    return {first_ + static_cast<double>(first) - 0.5, first_ + static_cast<double>(last) + 0.5};
  }

 private:
  double per_column_, per_row_;
  double first_ = 0;
  std::vector<int> counts_;
};

}  // namespace

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
  constexpr int cells_per_spare = 1000;
  const Pose2D corner_in_plot = pose_in_plot + grid.corner_in_map;
  const Point2D first = corner_in_plot.composePoint({grid.resolution / 2, grid.resolution / 2});
  const double c = std::cos(corner_in_plot.phi), s = std::sin(corner_in_plot.phi);
  // Where cells lie along the plot's axes, counted in cells from that of cell (0, 0).
  StripCounts along_x(c, -s, grid), along_y(s, c, grid);
  int known = 0;
  const CellState* cell = grid.cells.data();
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      if (*cell++ != CellState::Unknown) {
        along_x.add(column, row);
        along_y.add(column, row);
        ++known;
      }
    }
  }
  const auto [x0, x1] = along_x.mainSpan(known / cells_per_spare);
  const auto [y0, y1] = along_y.mainSpan(known / cells_per_spare);
  add({first.x + x0 * grid.resolution, first.y + y0 * grid.resolution});
  add({first.x + x1 * grid.resolution, first.y + y1 * grid.resolution});
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
