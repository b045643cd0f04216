// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/boxes_picture.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/sort_descending.h"
#include "sbox/report/drawing/figure.h"
#include "sbox/report/drawing/paint.h"
#include "sbox/report/drawing/text.h"

namespace sbox {
namespace {

/// Colours and numbers beyond this many are hard to tell apart.
constexpr size_t most_shown = palette::distinct.size();

double area(const BoxCorners& box) {
  const Point2D diagonal = box[2] - box[0], other = box[3] - box[1];
  return std::abs(diagonal.x * other.y - diagonal.y * other.x) / 2;
}

Point2D centre(const BoxCorners& box) {
  const Point2D sum = box[0] + box[1] + box[2] + box[3];
  return {sum.x / 4, sum.y / 4};
}

cv::Rect2d hull(const BoxCorners& box) {
  Bounds bounds;
  for (const Point2D& corner : box) {
    bounds.add(corner);
  }
  return {cv::Point2d(bounds.low.x, bounds.low.y), cv::Point2d(bounds.high.x, bounds.high.y)};
}

/// Area of what both upright hulls cover, over the area of what either covers.
double overlap(const BoxCorners& left, const BoxCorners& right) {
  const double both = (hull(left) & hull(right)).area();
  const double either = hull(left).area() + hull(right).area() - both;
  return either > 0 ? both / either : 1;
}

struct Match {
  BoxCorners in_a;
  BoxCorners in_b;
};

/// Matches that can be told apart at a glance: the largest first, but none that nearly covers one
/// taken before or whose number would be written within `label_gap` metres of another.
std::vector<Match> distinctMatches(const BoxesOfMap& a, const BoxesOfMap& b,
                                   const std::vector<std::pair<int, int>>& matched,
                                   double label_gap) {
  constexpr double most_overlap = 0.5;
  std::vector<Match> matches;
  matches.reserve(matched.size());
  for (const auto& [in_a, in_b] : matched) {
    matches.push_back(
        {a.boxes->at(static_cast<size_t>(in_a)), b.boxes->at(static_cast<size_t>(in_b))});
  }
  sortDescending(matches, [](const Match& match) { return area(match.in_a); });
  const auto alike = [&](const BoxCorners& left, const BoxCorners& right) {
    return overlap(left, right) > most_overlap || (centre(left) - centre(right)).norm() < label_gap;
  };
  std::vector<Match> shown;
  for (const Match& match : matches) {
    const bool new_to_eye = std::none_of(shown.begin(), shown.end(), [&](const Match& other) {
      return alike(match.in_a, other.in_a) || alike(match.in_b, other.in_b);
    });
    if (new_to_eye && shown.size() < most_shown) {
      shown.push_back(match);
    }
  }
  return shown;
}

palette::Colour colourOf(size_t match) { return palette::distinct[match]; }

cv::Mat drawSide(const StateGrid& grid, const std::vector<BoxCorners>& boxes,
                 const PlotView& view) {
  cv::Mat plot = paintCells(grid, view, palette::soft_wall);
  for (size_t i = 0; i < boxes.size(); ++i) {
    cv::Mat layer = plot.clone();
    fillBox(layer, view, boxes[i], palette::scalar(colourOf(i)));
    blend(plot, layer, 0.12);
  }
  for (size_t i = 0; i < boxes.size(); ++i) {
    paintBoxOutline(plot, view, boxes[i], colourOf(i), 3);
  }
  for (size_t i = 0; i < boxes.size(); ++i) {
    drawLabel(plot, std::to_string(i + 1), view.toPixels(centre(boxes[i])),
              {22, colourOf(i), true});
  }
  return plot;
}

}  // namespace

cv::Mat drawMatchedBoxes(const BoxesOfMap& a, const BoxesOfMap& b,
                         const std::vector<std::pair<int, int>>& matched) {
  Bounds bounds_a, bounds_b;
  bounds_a.add(*a.grid, {});
  bounds_b.add(*b.grid, {});
  const double resolution = std::min(a.grid->resolution, b.grid->resolution);
  const double scale = fitScale({bounds_a, bounds_b}, plot_long_side / 2, resolution);
  const std::vector<Match> matches = distinctMatches(a, b, matched, 40 / scale);
  std::vector<BoxCorners> boxes_a, boxes_b;
  for (const Match& match : matches) {
    boxes_a.push_back(match.in_a);
    boxes_b.push_back(match.in_b);
  }

  Figure figure;
  figure.title =
      std::to_string(matched.size()) + (matched.size() == 1 ? " matched box" : " matched boxes") +
      (matched.size() > matches.size() ? ", " + std::to_string(matches.size()) + " of them shown"
                                       : "");
  figure.plots = {drawSide(*a.grid, boxes_a, makeView(bounds_a, scale)),
                  drawSide(*b.grid, boxes_b, makeView(bounds_b, scale))};
  figure.captions = {a.name, b.name};
  figure.pixels_per_metre = scale;
  figure.legend = {
      {Swatch::Box, palette::quiet_ink, "same colour and number: one box in both maps"},
      {Swatch::Area, palette::soft_wall, "wall"},
      {Swatch::Area, palette::unknown, "unknown"}};
  return composeFigure(figure);
}

}  // namespace sbox
