// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/free_contours.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace sbox {
namespace {

cv::Mat maskOf(const StateGrid& grid, CellState state) {
  cv::Mat mask(grid.height, grid.width, CV_8U);
  std::transform(grid.cells.begin(), grid.cells.end(), mask.ptr<unsigned char>(),
                 [state](CellState cell) -> unsigned char { return cell == state ? 255 : 0; });
  return mask;
}

/// The free cells but those that touch another only at a corner, between two that are not free: a
/// slanted wall one cell thick is a wall.
cv::Mat openCells(const StateGrid& grid) {
  // A rim, so that each cell has all its neighbours.
  cv::Mat free;
  cv::copyMakeBorder(maskOf(grid, CellState::Free), free, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  const int width = grid.width;
  cv::Mat open(grid.height, width, CV_8U);
  for (int y = 0; y < grid.height; ++y) {
    const unsigned char* below = free.ptr<unsigned char>(y) + 1;
    const unsigned char* row = free.ptr<unsigned char>(y + 1) + 1;
    const unsigned char* above = free.ptr<unsigned char>(y + 2) + 1;
    auto* pixel = open.ptr<unsigned char>(y);
    for (int x = 0; x < width; ++x) {
      const int at_corner =
          (~row[x - 1] & ((below[x - 1] & ~below[x]) | (above[x - 1] & ~above[x]))) |
          (~row[x + 1] & ((below[x + 1] & ~below[x]) | (above[x + 1] & ~above[x])));
      pixel[x] = static_cast<unsigned char>(row[x] & ~at_corner);
    }
  }
  return open;
}

/// Twice the area to the left of the walk, in cells.
double signedArea(const std::vector<cv::Point>& walk) {
  double area = 0;
  for (size_t i = 0; i < walk.size(); ++i) {
    const cv::Point& from = walk[i];
    const cv::Point& to = walk[(i + 1) % walk.size()];
    area += static_cast<double>(from.x) * to.y - static_cast<double>(to.x) * from.y;
  }
  return area;
}

}  // namespace

std::vector<FreeContour> traceFreeContours(const StateGrid& grid, const ContourOptions& options) {
  std::vector<FreeContour> contours;
  if (grid.empty()) {
    return contours;
  }
  cv::Mat near_wall;
  cv::dilate(maskOf(grid, CellState::Occupied), near_wall,
             cv::getStructuringElement(cv::MORPH_RECT, {5, 5}));
  std::vector<std::vector<cv::Point>> walks;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(options.close_corners ? openCells(grid) : maskOf(grid, CellState::Free), walks,
                   hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  for (size_t i = 0; i < walks.size(); ++i) {
    std::vector<cv::Point>& walk = walks[i];
    if (static_cast<int>(walk.size()) < options.min_cells) {
      continue;
    }
    // Round an outer edge free space is what the walk encloses, round a hole what it does not.
    const bool is_hole = hierarchy[i][3] >= 0;
    if ((signedArea(walk) < 0) != is_hole) {
      std::reverse(walk.begin(), walk.end());
    }
    FreeContour& contour = contours.emplace_back();
    contour.reserve(walk.size());
    for (const cv::Point& cell : walk) {
      contour.push_back({cell.x, cell.y, near_wall.at<unsigned char>(cell) != 0});
    }
  }
  return contours;
}

}  // namespace sbox
