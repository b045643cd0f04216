// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/drawing/grid_raster.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace sbox {
namespace {

/// From the centre of a pixel (OpenCV's whole numbers) to the cell that holds it, likewise.
cv::Matx23d cellOfPixel(const StateGrid& grid, const Pose2D& pose_in_plot, const PlotView& view) {
  const Pose2D plot_in_grid = inverse(pose_in_plot + grid.corner_in_map);
  const auto cell = [&](double px, double py) {
    const Point2D in_plot{view.low.x + (px + 0.5) / view.pixels_per_metre,
                          view.low.y + (view.size.height - (py + 0.5)) / view.pixels_per_metre};
    const Point2D in_grid = plot_in_grid.composePoint(in_plot);
    return cv::Point2d{in_grid.x / grid.resolution - 0.5, in_grid.y / grid.resolution - 0.5};
  };
  const cv::Point2d origin = cell(0, 0);
  const cv::Point2d along_x = cell(1, 0) - origin, along_y = cell(0, 1) - origin;
  return {along_x.x, along_y.x, origin.x, along_x.y, along_y.y, origin.y};
}

cv::Mat mask(const StateGrid& grid, CellState state) {
  cv::Mat out(grid.height, grid.width, CV_8U);
  const CellState* cell = grid.cells.data();
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x, ++cell) {
      out.at<unsigned char>(y, x) = *cell == state ? 255 : 0;
    }
  }
  return out;
}

}  // namespace

GridRaster rasterize(const StateGrid& grid, const Pose2D& pose_in_plot, const PlotView& view,
                     int min_wall_pixels) {
  GridRaster raster{cv::Mat(view.size, CV_8U, cv::Scalar(0)),
                    cv::Mat(view.size, CV_8U, cv::Scalar(0))};
  if (grid.empty()) {
    return raster;
  }
  const double pixels_per_cell = grid.resolution * view.pixels_per_metre;
  const StateGrid shown = pixels_per_cell < 1 ? resample(grid, 1 / view.pixels_per_metre) : grid;
  const cv::Matx23d to_cell = cellOfPixel(shown, pose_in_plot, view);
  const int how = cv::INTER_NEAREST | cv::WARP_INVERSE_MAP;
  cv::warpAffine(mask(shown, CellState::Free), raster.free, to_cell, view.size, how);
  cv::warpAffine(mask(shown, CellState::Occupied), raster.occupied, to_cell, view.size, how);
  const int missing = min_wall_pixels - static_cast<int>(std::lround(pixels_per_cell));
  if (missing > 0) {
    const int width = missing + 1;
    cv::dilate(raster.occupied, raster.occupied,
               cv::getStructuringElement(cv::MORPH_ELLIPSE, {width, width}));
  }
  raster.free.setTo(0, raster.occupied);
  return raster;
}

}  // namespace sbox
