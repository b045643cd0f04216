// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/overlay_layers.h"

#include <algorithm>
#include <numeric>
#include <opencv2/imgproc.hpp>

namespace sbox {
namespace {

/// Pixels at most `metres` from a pixel of the mask. Measured in the plot's own pixels, which saves
/// most of the time where they are oversampled and shows nowhere.
cv::Mat within(const cv::Mat& mask, double metres, const PlotView& view) {
  cv::Mat small, distance, near;
  cv::resize(mask, small, view.size, 0, 0, cv::INTER_NEAREST);
  cv::distanceTransform(~small, distance, cv::DIST_L2, cv::DIST_MASK_5);
  cv::resize(distance <= metres * view.pixels_per_metre, near, mask.size(), 0, 0,
             cv::INTER_NEAREST);
  return near;
}

struct JudgedWalls {
  cv::Mat agreeing;
  cv::Mat conflicting;
};

/// What becomes of one map's walls in the light of the other.
JudgedWalls judge(const GridRaster& map, const GridRaster& other, const PlotView& view,
                  const OverlayOptions& options) {
  JudgedWalls walls;
  walls.agreeing = map.occupied & within(other.occupied, options.agree_within, view);
  const cv::Mat deep_free = ~within(~other.free, options.conflict_depth, view);
  walls.conflicting = map.occupied & deep_free & ~walls.agreeing;
  return walls;
}

/// The pixel of the mask that is nearest to the mean of all its pixels.
cv::Point middlePixel(const std::vector<cv::Point>& pixels) {
  const cv::Point sum = std::accumulate(pixels.begin(), pixels.end(), cv::Point(0, 0));
  const cv::Point mean = sum / static_cast<int>(pixels.size());
  const auto squared_distance = [&](const cv::Point& pixel) {
    const cv::Point offset = pixel - mean;
    return offset.dot(offset);
  };
  return *std::min_element(pixels.begin(), pixels.end(), [&](const auto& left, const auto& right) {
    return squared_distance(left) < squared_distance(right);
  });
}

}  // namespace

OverlayLayers overlayLayers(const StateGrid& a, const StateGrid& b, const Pose2D& pose_b_in_a,
                            const PlotView& view, int oversampling, const OverlayOptions& options) {
  const PlotView fine = view.enlarged(oversampling);
  const int min_wall = 2 * oversampling;
  OverlayLayers layers;
  layers.a = rasterize(a, {}, fine, min_wall);
  layers.b = rasterize(b, pose_b_in_a, fine, min_wall);
  const JudgedWalls walls_a = judge(layers.a, layers.b, view, options);
  const JudgedWalls walls_b = judge(layers.b, layers.a, view, options);
  layers.agreeing = walls_a.agreeing | walls_b.agreeing;
  layers.conflicting = walls_a.conflicting | walls_b.conflicting;
  return layers;
}

std::vector<cv::Point> conflictCentres(const cv::Mat& conflicting) {
  constexpr int square = 72;
  constexpr int enough = 40;
  std::vector<cv::Point> centres, pixels;
  for (int top = 0; top < conflicting.rows; top += square) {
    for (int left = 0; left < conflicting.cols; left += square) {
      const cv::Rect tile =
          cv::Rect(left, top, square, square) & cv::Rect({0, 0}, conflicting.size());
      cv::findNonZero(conflicting(tile), pixels);
      if (pixels.size() >= enough) {
        centres.push_back(tile.tl() + middlePixel(pixels));
      }
    }
  }
  return centres;
}

}  // namespace sbox
