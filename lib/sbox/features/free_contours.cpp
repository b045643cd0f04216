// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/free_contours.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace sbox {
namespace {

cv::Mat maskOf(const StateGrid& grid, CellState state) {
  cv::Mat mask(grid.height, grid.width, CV_8U);
  for (int y = 0; y < grid.height; ++y) {
    auto* pixel = mask.ptr<unsigned char>(y);
    const CellState* cell =
        grid.cells.data() + static_cast<size_t>(y) * static_cast<size_t>(grid.width);
    for (int x = 0; x < grid.width; ++x) {
      pixel[x] = cell[x] == state ? 255 : 0;
    }
  }
  return mask;
}

/// Without the pairs of free cells that only touch at a corner, between two that are not free: a
/// slanted wall one cell thick is a wall.
cv::Mat withoutPinches(const cv::Mat& free) {
  cv::Mat open = free.clone();
  for (int y = 0; y + 1 < free.rows; ++y) {
    const auto* low = free.ptr<unsigned char>(y);
    const auto* high = free.ptr<unsigned char>(y + 1);
    auto* open_low = open.ptr<unsigned char>(y);
    auto* open_high = open.ptr<unsigned char>(y + 1);
    for (int x = 0; x + 1 < free.cols; ++x) {
      const auto rising = static_cast<unsigned char>(low[x] & high[x + 1] & ~low[x + 1] & ~high[x]);
      const auto falling =
          static_cast<unsigned char>(low[x + 1] & high[x] & ~low[x] & ~high[x + 1]);
      open_low[x] &= static_cast<unsigned char>(~rising);
      open_high[x + 1] &= static_cast<unsigned char>(~rising);
      open_low[x + 1] &= static_cast<unsigned char>(~falling);
      open_high[x] &= static_cast<unsigned char>(~falling);
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
  cv::findContours(withoutPinches(maskOf(grid, CellState::Free)), walks, hierarchy, cv::RETR_CCOMP,
                   cv::CHAIN_APPROX_NONE);
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
