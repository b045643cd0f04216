// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/methods/keypoints.h"

#include <algorithm>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "sbox/core/state_grid.h"
#include "sbox/core/stopwatch.h"

namespace sbox::bench {
namespace {

constexpr int kBorder = 40;  ///< Pixels.

struct KeypointFeatures {
  std::vector<Point2D> points;  ///< In the map frame, metres.
  cv::Mat descriptors;
};

cv::Mat picture(const StateGrid& grid) {
  cv::Mat image(grid.height, grid.width, CV_8U);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const CellState state = grid.at(x, y);
      image.at<unsigned char>(y, x) = state == CellState::Free       ? 255
                                      : state == CellState::Occupied ? 0
                                                                     : 127;
    }
  }
  // Detectors skip the border of an image; the map must not lie in it.
  cv::copyMakeBorder(image, image, kBorder, kBorder, kBorder, kBorder, cv::BORDER_CONSTANT,
                     cv::Scalar(127));
  return image;
}

KeypointFeatures extract(const Map& map, const KeypointOptions& options) {
  KeypointFeatures features;
  const StateGrid grid = resample(classifyCells(map), options.resolution);
  if (grid.empty()) {
    return features;
  }
  std::vector<cv::KeyPoint> keypoints;
  const cv::Ptr<cv::Feature2D> detector =
      options.kind == KeypointKind::Orb
          ? cv::Ptr<cv::Feature2D>(cv::ORB::create(options.keypoints))
          : cv::Ptr<cv::Feature2D>(cv::SIFT::create(options.keypoints));
  detector->detectAndCompute(picture(grid), cv::noArray(), keypoints, features.descriptors);
  const auto metres = [&](float pixel) {
    return (static_cast<double>(pixel) - kBorder + 0.5) * grid.resolution;
  };
  for (const cv::KeyPoint& keypoint : keypoints) {
    features.points.push_back(
        grid.corner_in_map.composePoint({metres(keypoint.pt.x), metres(keypoint.pt.y)}));
  }
  return features;
}

PairResult match(const KeypointFeatures& a, const KeypointFeatures& b,
                 const KeypointOptions& options) {
  const Stopwatch stopwatch;
  PairResult result;
  if (a.points.empty() || b.points.empty()) {
    result.reason = "a map has no keypoint";
    return result;
  }
  const cv::BFMatcher matcher(options.kind == KeypointKind::Orb ? cv::NORM_HAMMING : cv::NORM_L2);
  std::vector<std::vector<cv::DMatch>> nearest;
  matcher.knnMatch(a.descriptors, b.descriptors, nearest, options.neighbours);
  std::vector<PointMatch> matches;
  for (const std::vector<cv::DMatch>& of_one : nearest) {
    for (const cv::DMatch& m : of_one) {
      matches.push_back(
          {a.points[static_cast<size_t>(m.queryIdx)], b.points[static_cast<size_t>(m.trainIdx)]});
    }
  }
  const RansacResult ransac = rigidRansac(matches, options.ransac);
  const auto inliers = static_cast<double>(ransac.inliers.size());
  const double confidence = inliers / (8 + 0.3 * static_cast<double>(matches.size()));
  result.has_pose = ransac.inliers.size() >= 2;
  result.pose_b_in_a = ransac.pose_b_in_a;
  result.confidence = std::min(1.0, confidence);
  const bool accepted = result.has_pose && confidence >= options.accept_confidence;
  result.verdict = accepted ? Verdict::Accepted : Verdict::Rejected;
  result.reason = std::to_string(ransac.inliers.size()) + " of " + std::to_string(matches.size()) +
                  " keypoint matches agree";
  result.seconds.matching = stopwatch.seconds();
  return result;
}

}  // namespace

Method keypointMethod(const KeypointOptions& options) {
  return makeMethod(
      options.kind == KeypointKind::Orb ? "orb" : "sift",
      [options](const Map& map) { return extract(map, options); },
      [options](const KeypointFeatures& a, const KeypointFeatures& b) {
        return match(a, b, options);
      });
}

std::vector<PointMatch> mutualKeypointMatches(const Map& map_a, const Map& map_b,
                                              const KeypointOptions& options) {
  const KeypointFeatures a = extract(map_a, options), b = extract(map_b, options);
  if (a.points.empty() || b.points.empty()) {
    return {};
  }
  const cv::BFMatcher matcher(options.kind == KeypointKind::Orb ? cv::NORM_HAMMING : cv::NORM_L2,
                              true);
  std::vector<cv::DMatch> mutual;
  matcher.match(a.descriptors, b.descriptors, mutual);
  std::vector<PointMatch> matches;
  for (const cv::DMatch& m : mutual) {
    matches.push_back(
        {a.points[static_cast<size_t>(m.queryIdx)], b.points[static_cast<size_t>(m.trainIdx)]});
  }
  return matches;
}

}  // namespace sbox::bench
