// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plots as inline SVG. Colours are CSS classes of the page (series-1 to series-5, grid, ink), so
// that a plot follows the reader's light or dark theme.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sbox::paper {

struct Axis {
  std::string label;
  double from = 0;
  double to = 1;
  double tick = 0.1;  ///< Distance between labelled ticks.
  int digits = 0;     ///< Decimals of the labels.
};

/// A plot that is built up mark by mark; marks outside the axes are drawn at their border.
class Plot {
 public:
  Plot(Axis x, Axis y);

  /// A line through the points, named in the legend unless `name` is empty; `series` from 1.
  void addLine(const std::string& name, int series,
               const std::vector<std::pair<double, double>>& points);
  /// A disc at each point, filled or hollow.
  void addPoints(const std::string& name, int series,
                 const std::vector<std::pair<double, double>>& points, bool filled = true);
  /// A dashed line across the plot at this y.
  void addLevel(const std::string& name, double y);
  /// A band between two curves over the same x.
  void addBand(int series, const std::vector<double>& x, const std::vector<double>& low,
               const std::vector<double>& high);

  /// The <svg> element; `title` is what screen readers say.
  [[nodiscard]] std::string svg(const std::string& title) const;

 private:
  [[nodiscard]] double px(double x) const;
  [[nodiscard]] double py(double y) const;
  void addLegend(const std::string& name, int series, const char* mark);

  Axis x_;
  Axis y_;
  std::string marks_;
  std::string legend_;
  double legend_at_;
};

/// One group of bars.
struct BarGroup {
  std::string label;
  std::vector<double> values;      ///< One a series, in [0, top].
  std::vector<std::string> texts;  ///< What stands over each bar.
};

/// Grouped bars, one colour a series, the y axis from 0 to `top`.
[[nodiscard]] std::string barsSvg(const std::string& title, const std::string& y_label, double top,
                                  const std::vector<std::string>& series,
                                  const std::vector<BarGroup>& groups);

}  // namespace sbox::paper
