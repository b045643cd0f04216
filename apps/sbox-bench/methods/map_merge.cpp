// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/methods/map_merge.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/stitching/detail/matchers.hpp>
#include <opencv2/stitching/detail/motion_estimators.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sbox/core/stopwatch.h"

namespace sbox::bench {
namespace {

struct ImageOfMap {
  cv::detail::ImageFeatures features;  ///< In cells; row 0 is the lowest.
  double resolution = 0;               ///< Metres.
  Pose2D corner_in_map;
};

/// The cells as in a nav_msgs/OccupancyGrid whose signed bytes are read as unsigned ones.
cv::Mat publishedBytes(const Map& map, const StateOptions& states) {
  cv::Mat image(map.height(), map.width(), CV_8U);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const double free = map.grid.getCell(x, y);
      image.at<unsigned char>(y, x) = free > states.free_above       ? 0
                                      : free < states.occupied_below ? 100
                                                                     : 255;
    }
  }
  return image;
}

ImageOfMap extract(const Map& map, const MapMergeOptions& options) {
  ImageOfMap result;
  result.resolution = map.resolution();
  result.corner_in_map = map.corner_in_map;
  cv::detail::computeImageFeatures(cv::AKAZE::create(), publishedBytes(map, options.states),
                                   result.features);
  return result;
}

/// Takes cells of b to cells of a; nothing where the package does not merge them.
std::optional<cv::Matx33d> similarity(std::vector<cv::detail::ImageFeatures> images,
                                      std::vector<cv::detail::MatchesInfo> matches,
                                      double confidence) {
  const std::vector<int> merged =
      cv::detail::leaveBiggestComponent(images, matches, static_cast<float>(confidence));
  // At the threshold itself nothing is left to adjust: OpenCV throws, and the package ends there.
  if (merged.size() < 2 || matches[1].confidence <= confidence) {
    return std::nullopt;
  }
  std::vector<cv::detail::CameraParams> cameras;
  cv::detail::AffineBasedEstimator estimate;
  if (!estimate(images, matches, cameras)) {
    return std::nullopt;
  }
  for (cv::detail::CameraParams& camera : cameras) {
    camera.R.convertTo(camera.R, CV_32F);
  }
  cv::detail::BundleAdjusterAffinePartial adjust;
  adjust.setConfThresh(confidence);
  if (!adjust(images, matches, cameras)) {
    return std::nullopt;
  }
  const cv::Matx33d reference_to_a(cameras[0].R), reference_to_b(cameras[1].R);
  return reference_to_a * reference_to_b.inv();
}

Pose2D rigidPose(const cv::Matx33d& cells_b_to_a, const ImageOfMap& a, const ImageOfMap& b) {
  const cv::Size size = b.features.img_size;
  // Pixel centres count from 0 in OpenCV: the centre of n pixels is (n - 1) / 2.
  const cv::Vec3d centre((size.width - 1) / 2.0, (size.height - 1) / 2.0, 1);
  const cv::Vec3d moved = cells_b_to_a * centre;
  Pose2D pose(0, 0, std::atan2(cells_b_to_a(1, 0), cells_b_to_a(0, 0)));
  const Point2D turned =
      pose.composePoint({(centre[0] + 0.5) * b.resolution, (centre[1] + 0.5) * b.resolution});
  pose.x = (moved[0] + 0.5) * a.resolution - turned.x;
  pose.y = (moved[1] + 0.5) * a.resolution - turned.y;
  return a.corner_in_map + (pose + inverse(b.corner_in_map));
}

PairResult match(const ImageOfMap& a, const ImageOfMap& b, const MapMergeOptions& options) {
  const Stopwatch stopwatch;
  PairResult result;
  if (a.features.keypoints.empty() || b.features.keypoints.empty()) {
    result.reason = "a map has no keypoint";
    return result;
  }
  // The matcher's search index draws from it.
  cv::setRNGSeed(1);
  const std::vector<cv::detail::ImageFeatures> images{a.features, b.features};
  std::vector<cv::detail::MatchesInfo> matches;
  cv::detail::AffineBestOf2NearestMatcher matcher;
  matcher(images, matches);
  const double confidence = matches[1].confidence;  // Of a to b.
  const std::optional<cv::Matx33d> cells_b_to_a = similarity(images, matches, options.confidence);
  if (cells_b_to_a) {
    result.has_pose = true;
    result.pose_b_in_a = rigidPose(*cells_b_to_a, a, b);
    result.verdict = Verdict::Accepted;
  }
  result.confidence = std::min(1.0, confidence);
  result.reason = std::to_string(matches[1].num_inliers) + " of " +
                  std::to_string(matches[1].matches.size()) + " keypoint matches agree";
  result.seconds.matching = stopwatch.seconds();
  return result;
}

}  // namespace

Method mapMergeMethod(const MapMergeOptions& options) {
  return makeMethod(
      "map_merge", [options](const Map& map) { return extract(map, options); },
      [options](const ImageOfMap& a, const ImageOfMap& b) { return match(a, b, options); });
}

}  // namespace sbox::bench
