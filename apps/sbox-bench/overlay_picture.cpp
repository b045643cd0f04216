// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/overlay_picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <stdexcept>

#include "sbox-bench/table.h"
#include "sbox/core/state_grid.h"

namespace sbox::bench {
namespace {

constexpr int kPanelPixels = 900;
constexpr int kMargin = 12;
constexpr int kLineHeight = 26;
constexpr size_t kTitleCharacters = 170;
const cv::Vec3b kBackground(190, 190, 190), kFreeA(225, 225, 255), kFreeB(255, 235, 225),
    kFreeBoth(255, 255, 255), kWallA(30, 30, 220), kWallB(220, 80, 20), kWallBoth(90, 0, 90);

/// A rectangle in the frame of map a, metres.
struct Extent {
  double x_low = std::numeric_limits<double>::max();
  double y_low = std::numeric_limits<double>::max();
  double x_high = std::numeric_limits<double>::lowest();
  double y_high = std::numeric_limits<double>::lowest();

  void add(const StateGrid& grid, const Pose2D& pose_map_in_a) {
    const Pose2D corner = pose_map_in_a + grid.corner_in_map;
    for (const double x : {0.0, grid.width * grid.resolution}) {
      for (const double y : {0.0, grid.height * grid.resolution}) {
        const Point2D p = corner.composePoint({x, y});
        x_low = std::min(x_low, p.x);
        x_high = std::max(x_high, p.x);
        y_low = std::min(y_low, p.y);
        y_high = std::max(y_high, p.y);
      }
    }
  }
};

CellState stateAt(const StateGrid& grid, const Pose2D& a_in_grid, const Point2D& point_in_a) {
  const Point2D p = a_in_grid.composePoint(point_in_a);
  return grid.at(static_cast<int>(std::floor(p.x / grid.resolution)),
                 static_cast<int>(std::floor(p.y / grid.resolution)));
}

cv::Vec3b colour(CellState a, CellState b) {
  if (a == CellState::Occupied || b == CellState::Occupied) {
    return a != b ? (a == CellState::Occupied ? kWallA : kWallB) : kWallBoth;
  }
  if (a == CellState::Free || b == CellState::Free) {
    return a != b ? (a == CellState::Free ? kFreeA : kFreeB) : kFreeBoth;
  }
  return kBackground;
}

/// Where b is drawn if there is no pose: to the right of a.
Pose2D apart(const StateGrid& a, const StateGrid& b) {
  Extent of_a, of_b;
  of_a.add(a, {});
  of_b.add(b, {});
  return {of_a.x_high - of_b.x_low + 1, of_a.y_low - of_b.y_low, 0};
}

cv::Mat panel(const StateGrid& a, const StateGrid& b, const Pose2D& pose_b_in_a) {
  Extent extent;
  extent.add(a, {});
  extent.add(b, pose_b_in_a);
  const double width = extent.x_high - extent.x_low, height = extent.y_high - extent.y_low;
  const double pixel = std::max(width, height) / kPanelPixels;
  // Coarser cells first, or thin walls fall between the pixels.
  const StateGrid seen_a = resample(a, std::max(pixel, a.resolution));
  const StateGrid seen_b = resample(b, std::max(pixel, b.resolution));
  const Pose2D a_in_grid_a = inverse(seen_a.corner_in_map);
  const Pose2D a_in_grid_b = inverse(pose_b_in_a + seen_b.corner_in_map);
  cv::Mat image(static_cast<int>(std::ceil(height / pixel)),
                static_cast<int>(std::ceil(width / pixel)), CV_8UC3, cv::Scalar(kBackground));
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const Point2D point(extent.x_low + (column + 0.5) * pixel,
                          extent.y_low + (image.rows - row - 0.5) * pixel);
      image.at<cv::Vec3b>(row, column) =
          colour(stateAt(seen_a, a_in_grid_a, point), stateAt(seen_b, a_in_grid_b, point));
    }
  }
  return image;
}

std::vector<std::string> titleLines(const AnnotatedPair& pair, const Answer& answer) {
  const PairResult& result = answer.result;
  std::string text = pair.a + " (red) and " + pair.b + " (blue): " + toString(answer.outcome) +
                     "; " + toString(result.verdict) + ", confidence " +
                     formatNumber(result.confidence, 3) + ": " + result.reason;
  std::vector<std::string> lines;
  while (text.size() > kTitleCharacters) {
    const size_t space = text.rfind(' ', kTitleCharacters);
    const size_t end = space == std::string::npos || space == 0 ? kTitleCharacters : space;
    lines.push_back(text.substr(0, end));
    text.erase(0, end);
  }
  lines.push_back(text);
  return lines;
}

std::string answerCaption(const Answer& answer) {
  if (!answer.result.has_pose) {
    return "no answer";
  }
  const Pose2D& pose = answer.result.pose_b_in_a;
  std::string text = "answer: x " + formatNumber(pose.x, 2) + " y " + formatNumber(pose.y, 2) +
                     " m, " + formatNumber(pose.phi * 180 / M_PI, 1) + " deg";
  if (answer.error) {
    text += "; " + formatNumber(answer.error->excess_cells, 1) + " cells over the floor, " +
            formatNumber(answer.error->rotation_deg, 1) + " deg off";
  }
  return text;
}

void write(cv::Mat& image, const std::string& text, int x, int y) {
  cv::putText(image, text, {x, y}, cv::FONT_HERSHEY_SIMPLEX, 0.55, {0, 0, 0}, 1, cv::LINE_AA);
}

}  // namespace

void writeOverlay(const std::string& path, const LoadedFolder& loaded, size_t pair,
                  const Answer& answer) {
  const AnnotatedPair& annotation = loaded.folder.pairs[pair];
  const Map& map_a = loaded.maps[static_cast<size_t>(loaded.map_of_pair[pair].first)];
  const Map& map_b = loaded.maps[static_cast<size_t>(loaded.map_of_pair[pair].second)];
  const StateGrid a = classifyCells(map_a), b = classifyCells(map_b);
  const Pose2D truth =
      annotation.negative
          ? apart(a, b)
          : poseFromCorners(trueCornerAInCornerB(annotation, loaded.folder.resolution),
                            map_a.corner_in_map, map_b.corner_in_map);
  const cv::Mat left =
      panel(a, b, answer.result.has_pose ? answer.result.pose_b_in_a : apart(a, b));
  const cv::Mat right = panel(a, b, truth);

  const std::vector<std::string> title = titleLines(annotation, answer);
  const int top = kLineHeight * (static_cast<int>(title.size()) + 1) + kMargin;
  cv::Mat image(top + std::max(left.rows, right.rows) + kMargin, 2 * kPanelPixels + 4 * kMargin,
                CV_8UC3, cv::Scalar::all(255));
  int y = kLineHeight - 6;
  for (const std::string& line : title) {
    write(image, line, kMargin, y);
    y += kLineHeight;
  }
  write(image, answerCaption(answer), kMargin, y);
  const int right_x = kPanelPixels + 2 * kMargin;
  write(image, annotation.negative ? "truth: nothing in common" : "truth", right_x, y);
  left.copyTo(image(cv::Rect(kMargin, top, left.cols, left.rows)));
  right.copyTo(image(cv::Rect(right_x, top, right.cols, right.rows)));
  if (!cv::imwrite(path, image)) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

}  // namespace sbox::bench
