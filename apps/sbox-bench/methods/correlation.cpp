// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/methods/correlation.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "sbox-bench/methods/hough_spectrum.h"
#include "sbox/core/state_grid.h"
#include "sbox/core/stopwatch.h"

namespace sbox::bench {
namespace {

struct CorrelationFeatures {
  cv::Mat signed_image;  ///< Float; walls positive, free negative; row 0 lowest.
  double direction = 0;  ///< Of the walls in the grid, radians in [0, pi/2).
  Pose2D corner_in_map;
};

struct Peak {
  double value = 0;
  Pose2D grid_b_in_grid_a;  ///< Between the grids' corners, metres.
};

CorrelationFeatures extract(const Map& map, const CorrelationOptions& options) {
  const StateGrid grid = resample(classifyCells(map), options.resolution);
  CorrelationFeatures features;
  features.corner_in_map = grid.corner_in_map;
  if (grid.empty()) {
    return features;
  }
  cv::Mat walls(grid.height, grid.width, CV_32F), free(grid.height, grid.width, CV_32F);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      walls.at<float>(y, x) = grid.at(x, y) == CellState::Occupied ? 1.F : 0.F;
      free.at<float>(y, x) = grid.at(x, y) == CellState::Free ? 1.F : 0.F;
    }
  }
  cv::GaussianBlur(walls, walls, {}, options.wall_blur / options.resolution);
  features.signed_image = walls - options.free_weight * free;
  features.direction = dominantDirection(
      houghSpectrum(wallPoints(grid), options.direction_bins, options.resolution));
  return features;
}

/// Image b turned by `angle` about its centre, on a square canvas that holds it at any angle.
cv::Mat turned(const cv::Mat& image, double angle) {
  const int side = static_cast<int>(std::ceil(std::hypot(image.cols, image.rows))) + 1;
  const double c = std::cos(angle), s = std::sin(angle);
  // Pixel centres count from 0 in OpenCV: the centre of n pixels is (n - 1) / 2.
  const double from_x = (image.cols - 1) / 2.0, from_y = (image.rows - 1) / 2.0;
  const double to = (side - 1) / 2.0;
  const cv::Matx23d forward(c, -s, to - c * from_x + s * from_y,  //
                            s, c, to - s * from_x - c * from_y);
  cv::Mat result;
  cv::warpAffine(image, result, forward, {side, side}, cv::INTER_LINEAR);
  return result;
}

cv::Mat spectrum(const cv::Mat& image, const cv::Size& size) {
  cv::Mat padded = cv::Mat::zeros(size, CV_32F), result;
  image.copyTo(padded(cv::Rect(0, 0, image.cols, image.rows)));
  cv::dft(padded, result, 0, image.rows);
  return result;
}

Peak bestShift(const cv::Mat& spectrum_a, const cv::Mat& b, const cv::Size& size, double angle,
               double resolution) {
  const cv::Mat turned_b = turned(b, angle);
  cv::Mat product, correlation;
  cv::mulSpectrums(spectrum_a, spectrum(turned_b, size), product, 0, true);
  cv::dft(product, correlation, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
  Peak peak;
  cv::Point place;
  cv::minMaxLoc(correlation, nullptr, &peak.value, nullptr, &place);
  // Shifts of the turned canvas to the left or down come out wrapped round.
  const double shift_x = place.x > size.width - turned_b.cols ? place.x - size.width : place.x;
  const double shift_y = place.y > size.height - turned_b.rows ? place.y - size.height : place.y;
  const double c = std::cos(angle), s = std::sin(angle);
  const double centre = turned_b.cols / 2.0, from_x = b.cols / 2.0, from_y = b.rows / 2.0;
  peak.grid_b_in_grid_a = {(shift_x + centre - c * from_x + s * from_y) * resolution,
                           (shift_y + centre - s * from_x - c * from_y) * resolution,
                           wrapAngle(angle)};
  return peak;
}

PairResult match(const CorrelationFeatures& a, const CorrelationFeatures& b,
                 const CorrelationOptions& options) {
  const Stopwatch stopwatch;
  PairResult result;
  if (a.signed_image.empty() || b.signed_image.empty()) {
    result.reason = "a map has no known cell";
    return result;
  }
  const int side_b = turned(b.signed_image, 0).cols;
  const cv::Size size(cv::getOptimalDFTSize(a.signed_image.cols + side_b),
                      cv::getOptimalDFTSize(a.signed_image.rows + side_b));
  const cv::Mat spectrum_a = spectrum(a.signed_image, size);
  Peak best;
  double runner_up = 0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    Peak best_of_turn;
    for (int fine = -options.fine_angles; fine <= options.fine_angles; ++fine) {
      const double angle =
          a.direction - b.direction + quarter * M_PI / 2 + fine * options.fine_step;
      const Peak peak = bestShift(spectrum_a, b.signed_image, size, angle, options.resolution);
      best_of_turn = peak.value > best_of_turn.value ? peak : best_of_turn;
    }
    runner_up = std::max(runner_up, std::min(best.value, best_of_turn.value));
    best = best_of_turn.value > best.value ? best_of_turn : best;
  }
  result.has_pose = true;
  result.pose_b_in_a = a.corner_in_map + (best.grid_b_in_grid_a + inverse(b.corner_in_map));
  result.verdict = Verdict::Accepted;
  result.reason = "the highest correlation; this method never refuses";
  result.confidence = best.value > 0 ? 1 - runner_up / (2 * best.value) : 0;
  result.seconds.matching = stopwatch.seconds();
  return result;
}

}  // namespace

Method correlationMethod(const CorrelationOptions& options) {
  return makeMethod(
      "correlation", [options](const Map& map) { return extract(map, options); },
      [options](const CorrelationFeatures& a, const CorrelationFeatures& b) {
        return match(a, b, options);
      });
}

}  // namespace sbox::bench
