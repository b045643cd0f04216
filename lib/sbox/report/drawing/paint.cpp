// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/drawing/paint.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "sbox/report/drawing/grid_raster.h"

namespace sbox {
namespace {

/// Bits after the point of OpenCV's fixed-point pixel coordinates.
constexpr int shift = 4;

cv::Point fixedPoint(const PlotView& view, const Point2D& point) {
  // OpenCV's whole numbers are pixel centres. Far outside the plot its integers would overflow.
  const cv::Point2d pixel = view.toPixels(point) - cv::Point2d(0.5, 0.5);
  const double limit = 1e5;
  const auto fixed = [&](double value) {
    return static_cast<int>(std::lround(std::clamp(value, -limit, limit) * (1 << shift)));
  };
  return {fixed(pixel.x), fixed(pixel.y)};
}

std::vector<cv::Point> fixedCorners(const PlotView& view, const BoxCorners& box) {
  std::vector<cv::Point> corners;
  for (const Point2D& corner : box) {
    corners.push_back(fixedPoint(view, corner));
  }
  return corners;
}

}  // namespace

cv::Mat paintCells(const StateGrid& grid, const PlotView& view, const palette::Colour& wall) {
  constexpr int oversampling = 2;
  const PlotView fine = view.enlarged(oversampling);
  const GridRaster raster = rasterize(grid, {}, fine, 2 * oversampling);
  cv::Mat canvas(fine.size, CV_8UC3, palette::scalar(palette::unknown));
  canvas.setTo(palette::scalar(palette::free_space), raster.free);
  canvas.setTo(palette::scalar(wall), raster.occupied);
  cv::Mat plot;
  cv::resize(canvas, plot, view.size, 0, 0, cv::INTER_AREA);
  return plot;
}

void paintLine(cv::Mat& plot, const PlotView& view, const Point2D& from, const Point2D& to,
               const palette::Colour& colour, int width) {
  cv::line(plot, fixedPoint(view, from), fixedPoint(view, to), palette::scalar(colour), width,
           cv::LINE_AA, shift);
}

void paintDot(cv::Mat& plot, const PlotView& view, const Point2D& centre,
              const palette::Colour& colour, int radius) {
  const cv::Point pixel = fixedPoint(view, centre);
  cv::circle(plot, pixel, (radius + 2) << shift, palette::scalar(palette::paper), cv::FILLED,
             cv::LINE_AA, shift);
  cv::circle(plot, pixel, radius << shift, palette::scalar(colour), cv::FILLED, cv::LINE_AA, shift);
}

void paintBoxOutline(cv::Mat& plot, const PlotView& view, const BoxCorners& box,
                     const palette::Colour& colour, int width) {
  cv::polylines(plot, fixedCorners(view, box), true, palette::scalar(colour), width, cv::LINE_AA,
                shift);
}

void fillBox(cv::Mat& plot, const PlotView& view, const BoxCorners& box, const cv::Scalar& value) {
  cv::fillConvexPoly(plot, fixedCorners(view, box), value, cv::LINE_8, shift);
}

void blend(cv::Mat& plot, const cv::Mat& layer, double share) {
  cv::addWeighted(plot, 1 - share, layer, share, 0, plot);
}

}  // namespace sbox
