// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/matching/correlation_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "sbox/alignment/plausibility.h"
#include "sbox/core/parallel.h"
#include "sbox/core/sort_descending.h"
#include "sbox/matching/turned_bounds.h"

namespace sbox {
namespace {

/// Coarse pictures of a map turned by a heading, float, row 0 lowest.
struct Pictures {
  cv::Mat facing_x, facing_y;  ///< Wall in metres times its normal.
  cv::Mat wall;                ///< Metres.
  cv::Mat conflict;            ///< Share of the cell in which a wall would be in conflict.
  cv::Mat free;                ///< Share of the cell that is free.
};

/// Where the pictures of a turned map lie.
struct Canvas {
  Eigen::Vector2d low;  ///< Of the picture's lower-left corner, metres.
  cv::Size size;
  double resolution = 0;
};

/// With a rim of `margin` cells.
Canvas canvasFor(const MapFeatures& map, double heading, double resolution, int margin) {
  const auto [low, high] = turnedBounds(map, heading);
  const Eigen::Vector2d cells = (high - low) / resolution;
  return {low - Eigen::Vector2d::Constant(margin * resolution),
          {static_cast<int>(std::ceil(cells.x())) + 1 + 2 * margin,
           static_cast<int>(std::ceil(cells.y())) + 1 + 2 * margin},
          resolution};
}

Pictures draw(const MapFeatures& map, double heading, const Canvas& canvas, const cv::Size& size,
              const EvidenceOptions& evidence) {
  Pictures pictures;
  for (cv::Mat* picture : {&pictures.facing_x, &pictures.facing_y, &pictures.wall,
                           &pictures.conflict, &pictures.free}) {
    *picture = cv::Mat::zeros(size, CV_32F);
  }
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(heading).toRotationMatrix();
  const auto cellOf = [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d place = (turn * point - canvas.low) / canvas.resolution;
    return cv::Point(std::clamp(static_cast<int>(place.x()), 0, canvas.size.width - 1),
                     std::clamp(static_cast<int>(place.y()), 0, canvas.size.height - 1));
  };
  for (const WallPoint& point : map.wall_points) {
    const cv::Point cell = cellOf(point.position);
    const Eigen::Vector2d normal = turn * point.normal * map.point_spacing;
    pictures.facing_x.at<float>(cell) += static_cast<float>(normal.x());
    pictures.facing_y.at<float>(cell) += static_cast<float>(normal.y());
    pictures.wall.at<float>(cell) += static_cast<float>(map.point_spacing);
  }
  const auto share =
      static_cast<float>(map.free_point_area / (canvas.resolution * canvas.resolution));
  for (const Eigen::Vector2d& point : map.free_points) {
    const cv::Point cell = cellOf(point);
    const double depth = map.fields.depthAt(point) * WallFields::depth_unit;
    pictures.free.at<float>(cell) += share;
    pictures.conflict.at<float>(cell) +=
        share * static_cast<float>(conflictWeight(depth, evidence));
  }
  return pictures;
}

/// From wall per cell to how well a wall there agrees: the distance kernel is 1 on the wall.
void blurToAgreement(Pictures& pictures, double sigma, double resolution) {
  const double scale = std::sqrt(2 * M_PI) * sigma / (resolution * resolution);
  for (cv::Mat* picture : {&pictures.facing_x, &pictures.facing_y}) {
    cv::GaussianBlur(*picture, *picture, {}, sigma / resolution, 0, cv::BORDER_CONSTANT);
    *picture *= scale;
    cv::max(cv::min(*picture, 1.0), -1.0, *picture);
  }
}

/// Of a picture that is empty from row `rows` on.
cv::Mat spectrum(const cv::Mat& picture, int rows) {
  cv::Mat result;
  cv::dft(picture, result, 0, rows);
  return result;
}

struct Spectra {
  cv::Mat facing_x, facing_y, wall, conflict, free;

  Spectra(const Pictures& pictures, int rows)
      : facing_x(spectrum(pictures.facing_x, rows)),
        facing_y(spectrum(pictures.facing_y, rows)),
        wall(spectrum(pictures.wall, rows)),
        conflict(spectrum(pictures.conflict, rows)),
        free(spectrum(pictures.free, rows)) {}
};

/// For each shift the sum over all cells of a(cell + shift) b(cell), of one or two pairs.
cv::Mat correlate(const cv::Mat& a, const cv::Mat& b, const cv::Mat& second_a = {},
                  const cv::Mat& second_b = {}) {
  cv::Mat product, result;
  cv::mulSpectrums(a, b, product, 0, true);
  if (!second_a.empty()) {
    cv::Mat second;
    cv::mulSpectrums(second_a, second_b, second, 0, true);
    product += second;
  }
  cv::dft(product, result, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
  return result;
}

/// How plausible each shift of map b over map a is.
cv::Mat scoreShifts(const Spectra& a, const Spectra& b, double resolution, double min_agree) {
  const cv::Mat agree = correlate(a.facing_x, b.facing_x, a.facing_y, b.facing_y);
  const cv::Mat known = correlate(a.free, b.wall, a.wall, b.free);
  const cv::Mat conflict = correlate(a.conflict, b.wall, a.wall, b.conflict);
  const cv::Mat free_free = correlate(a.free, b.free);
  cv::Mat scores(agree.size(), CV_32F);
  Overlap found;
  for (int y = 0; y < scores.rows; ++y) {
    const auto* agree_row = agree.ptr<float>(y);
    const auto* known_row = known.ptr<float>(y);
    const auto* conflict_row = conflict.ptr<float>(y);
    const auto* free_row = free_free.ptr<float>(y);
    auto* score_row = scores.ptr<float>(y);
    for (int x = 0; x < scores.cols; ++x) {
      found.agree = 2 * std::max(0.F, agree_row[x]);
      found.known = std::max(0.F, known_row[x]) + found.agree;
      if (found.agree < min_agree * found.known) {
        score_row[x] = static_cast<float>(kImplausible);
        continue;
      }
      found.conflict = std::max(0.F, conflict_row[x]);
      found.free_free = std::max(0.F, free_row[x]) * resolution * resolution;
      score_row[x] = static_cast<float>(plausibility(found));
    }
  }
  return scores;
}

/// The most plausible shifts, none near a better one.
std::vector<std::pair<double, cv::Point>> bestShifts(const cv::Mat& scores, int count, int radius) {
  // A shift counts if nothing about it is better: dilation finds these at once.
  cv::Mat highest;
  cv::dilate(scores, highest,
             cv::getStructuringElement(cv::MORPH_RECT, {2 * radius + 1, 2 * radius + 1}));
  std::vector<std::pair<double, cv::Point>> found;
  for (int y = 0; y < scores.rows; ++y) {
    const auto* score = scores.ptr<float>(y);
    const auto* high = highest.ptr<float>(y);
    for (int x = 0; x < scores.cols; ++x) {
      if (score[x] >= high[x] && score[x] > static_cast<float>(kImplausible)) {
        found.emplace_back(score[x], cv::Point(x, y));
      }
    }
  }
  const auto better = [](const auto& left, const auto& right) {
    return std::make_tuple(-left.first, left.second.y, left.second.x) <
           std::make_tuple(-right.first, right.second.y, right.second.x);
  };
  std::sort(found.begin(), found.end(), better);
  found.resize(std::min(found.size(), static_cast<size_t>(count)));
  return found;
}

}  // namespace

std::vector<Hypothesis> searchByCorrelation(const MapFeatures& a, const MapFeatures& b,
                                            const CorrelationSearchOptions& options,
                                            const EvidenceOptions& evidence, int threads) {
  const double largest = std::max({a.width, a.height, std::hypot(b.width, b.height)});
  const double resolution = std::max(options.resolution, largest / options.most_cells);
  const double blur = std::max(options.wall_blur, 0.8 * resolution);
  // Walls at the edge of map a speak for walls just beyond it.
  const Canvas canvas_a =
      canvasFor(a, 0, resolution, static_cast<int>(std::ceil(3 * blur / resolution)));
  const int side_b = static_cast<int>(std::ceil(std::hypot(b.width, b.height) / resolution)) + 2;
  const cv::Size size(cv::getOptimalDFTSize(canvas_a.size.width + side_b),
                      cv::getOptimalDFTSize(canvas_a.size.height + side_b));
  Pictures pictures_a = draw(a, 0, canvas_a, size, evidence);
  blurToAgreement(pictures_a, blur, resolution);
  const Spectra spectra_a(pictures_a, size.height);

  const std::vector<double> headings = findHeadings(a, b, options.headings);
  std::vector<std::vector<Hypothesis>> of_headings(headings.size());
  parallelFor(static_cast<int>(headings.size()), threads, [&](int i) {
    const double heading = headings[static_cast<size_t>(i)];
    const Canvas canvas_b = canvasFor(b, heading, resolution, 0);
    const Spectra spectra_b(draw(b, heading, canvas_b, size, evidence), canvas_b.size.height);
    const cv::Mat scores = scoreShifts(spectra_a, spectra_b, resolution, options.min_agree);
    const int radius = std::max(1, static_cast<int>(options.separation / resolution));
    for (const auto& [score, place] : bestShifts(scores, options.per_heading, radius)) {
      // Shifts to the left or down come out wrapped round.
      const int shift_x = place.x >= canvas_a.size.width ? place.x - size.width : place.x;
      const int shift_y = place.y >= canvas_a.size.height ? place.y - size.height : place.y;
      const Eigen::Vector2d shift = Eigen::Vector2d(shift_x, shift_y) * resolution;
      of_headings[static_cast<size_t>(i)].push_back(
          {{heading, canvas_a.low + shift - canvas_b.low}, score});
    }
  });
  std::vector<Hypothesis> hypotheses;
  for (const std::vector<Hypothesis>& of_heading : of_headings) {
    hypotheses.insert(hypotheses.end(), of_heading.begin(), of_heading.end());
  }
  sortDescending(hypotheses, [](const Hypothesis& hypothesis) { return hypothesis.votes; });
  return hypotheses;
}

}  // namespace sbox
