// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/drawing/figure.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "sbox/report/drawing/text.h"
#include "sbox/report/words.h"

namespace sbox {
namespace {

constexpr int figure_margin = 36;
constexpr int gap = 28;
constexpr int min_width = 1300;
constexpr int line_height = 46;
const TextStyle title_style{23, palette::ink, true};
const TextStyle small_style{19, palette::ink, false};

/// The title in letters as large as its length allows, down to a size still to be read.
void drawTitle(cv::Mat& picture, const std::string& title, int width) {
  constexpr double least_cap_height = 15;
  TextStyle style = title_style;
  while (style.cap_height > least_cap_height && textWidth(title, style) > width) {
    style.cap_height -= 1;
  }
  drawText(picture, shortened(title, width, style), {figure_margin, 54}, style);
}

/// The length of the bar in metres: a round one that takes at most 320 pixels.
double barLength(double pixels_per_metre) { return roundLength(320 / pixels_per_metre); }

/// Draws the bar with its right end at `right_end`; returns the x of its left end.
int drawScaleBar(cv::Mat& picture, cv::Point right_end, double pixels_per_metre) {
  const double metres = barLength(pixels_per_metre);
  const int length = static_cast<int>(std::lround(metres * pixels_per_metre));
  const std::string text = lengthText(metres);
  const int text_width = textWidth(text, small_style);
  const cv::Point right(right_end.x - text_width - 16, right_end.y),
      left = right - cv::Point(length, 0);
  const cv::Scalar ink = palette::scalar(palette::ink);
  cv::rectangle(picture, left - cv::Point(0, 3), right + cv::Point(0, 3), ink, cv::FILLED);
  for (const cv::Point& end : {left, right}) {
    cv::rectangle(picture, end - cv::Point(1, 11), end + cv::Point(1, 11), ink, cv::FILLED);
  }
  drawText(picture, text, {right.x + 16, right.y + 9}, small_style);
  return left.x;
}

constexpr int swatch_width = 38;

void drawSwatch(cv::Mat& picture, cv::Point middle_left, const LegendEntry& entry) {
  const cv::Scalar colour = palette::scalar(entry.colour);
  const cv::Rect patch(middle_left.x, middle_left.y - 12, swatch_width - 6, 24);
  const cv::Point centre(middle_left.x + patch.width / 2, middle_left.y);
  switch (entry.swatch) {
    case Swatch::Area:
      cv::rectangle(picture, patch, colour, cv::FILLED);
      cv::rectangle(picture, patch, palette::scalar(palette::frame), 1);
      break;
    case Swatch::Line:
      cv::line(picture, middle_left, middle_left + cv::Point(patch.width, 0), colour, 6,
               cv::LINE_AA);
      break;
    case Swatch::Dot:
      cv::circle(picture, centre, 9, colour, cv::FILLED, cv::LINE_AA);
      break;
    case Swatch::Box: {
      cv::Mat inside = picture(patch);
      cv::addWeighted(inside, 0.7, cv::Mat(inside.size(), inside.type(), colour), 0.3, 0, inside);
      cv::rectangle(picture, patch, colour, 2, cv::LINE_AA);
      break;
    }
    case Swatch::Ring:
      cv::circle(picture, centre, 11, colour, 3, cv::LINE_AA);
      break;
  }
}

struct Row {
  std::vector<LegendEntry> entries;
  int width = 0;
};

int entryWidth(const LegendEntry& entry) {
  return swatch_width + 8 + textWidth(entry.text, small_style) + 34;
}

/// Breaks the legend into lines of at most `width` pixels; the first shares its line with the bar.
std::vector<Row> breakLegend(const std::vector<LegendEntry>& legend, int first_width, int width) {
  std::vector<Row> rows(1);
  for (const LegendEntry& entry : legend) {
    const int limit = rows.size() == 1 ? first_width : width;
    if (!rows.back().entries.empty() && rows.back().width + entryWidth(entry) > limit) {
      rows.emplace_back();
    }
    rows.back().entries.push_back(entry);
    rows.back().width += entryWidth(entry);
  }
  return rows;
}

}  // namespace

cv::Mat composeFigure(const Figure& figure) {
  int plots_width = -gap, plots_height = 0;
  for (const cv::Mat& plot : figure.plots) {
    plots_width += gap + plot.cols;
    plots_height = std::max(plots_height, plot.rows);
  }
  const int inner_width = std::max(plots_width, min_width);
  const double bar_metres = barLength(figure.pixels_per_metre);
  const int bar_width = static_cast<int>(bar_metres * figure.pixels_per_metre) +
                        textWidth(lengthText(bar_metres), small_style) + 40;
  const std::vector<Row> rows = breakLegend(figure.legend, inner_width - bar_width, inner_width);
  const int top = 84;
  const int caption_height = figure.captions.empty() ? 0 : line_height;
  const int foot = top + plots_height + caption_height + 46;
  cv::Mat picture(foot + static_cast<int>(rows.size()) * line_height,
                  inner_width + 2 * figure_margin, CV_8UC3, palette::scalar(palette::paper));

  drawTitle(picture, figure.title, inner_width);
  int x = figure_margin + (inner_width - plots_width) / 2;
  for (size_t i = 0; i < figure.plots.size(); ++i) {
    const cv::Mat& plot = figure.plots[i];
    const cv::Rect place(x, top + (plots_height - plot.rows) / 2, plot.cols, plot.rows);
    plot.copyTo(picture(place));
    cv::rectangle(picture, place, palette::scalar(palette::frame), 1);
    if (i < figure.captions.size()) {
      const std::string caption = shortened(figure.captions[i], plot.cols, small_style);
      const int indent = (plot.cols - textWidth(caption, small_style)) / 2;
      drawText(picture, caption, {x + indent, top + plots_height + 36}, small_style);
    }
    x += plot.cols + gap;
  }
  drawScaleBar(picture, {figure_margin + inner_width, foot}, figure.pixels_per_metre);
  int y = foot;
  for (const Row& row : rows) {
    int left = figure_margin;
    for (const LegendEntry& entry : row.entries) {
      drawSwatch(picture, {left, y}, entry);
      drawText(picture, entry.text, {left + swatch_width + 8, y + 9}, small_style);
      left += entryWidth(entry);
    }
    y += line_height;
  }
  return picture;
}

std::vector<unsigned char> encodePng(const cv::Mat& picture) {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", picture, bytes)) {
    throw std::runtime_error("OpenCV cannot encode PNG files");
  }
  return bytes;
}

}  // namespace sbox
