// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/paper_method.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "sbox/core/number_text.h"
#include "sbox/core/pose_errors.h"
#include "sbox/core/stopwatch.h"
#include "sbox/paper/kalman_step.h"

namespace sbox {
namespace {

// Share of right transforms among the answers accepted and refused on the 91 Halmstad E5 pairs.
constexpr double kRightWhenAccepted = 0.3;
constexpr double kRightWhenRejected = 0.1;

/// The features in the map frame.
FeatureSet describe(const Pose2D& corner_in_map, const std::vector<HoughLine>& lines,
                    const std::vector<PointCluster>& points,
                    const std::vector<SuppositionalBox>& boxes) {
  FeatureSet set;
  for (const HoughLine& line : lines) {
    set.lines.push_back(
        {corner_in_map.composePoint(line.from), corner_in_map.composePoint(line.to)});
  }
  for (const PointCluster& point : points) {
    set.vertical_points.push_back(corner_in_map.composePoint(point.position));
  }
  for (const SuppositionalBox& box : boxes) {
    std::array<Point2D, 4>& corners = set.boxes.emplace_back();
    for (size_t i = 0; i < 4; ++i) {
      corners[i] = corner_in_map.composePoint(box.corners[i]);
    }
  }
  return set;
}

/// Covariance of the frame of map b in that of map a, from that of grid a in grid b.
PoseCovariance poseCovariance(const PaperFeatures& a, const PaperFeatures& b,
                              const KalmanResult& kalman) {
  // Cell (0, 0) of b to the frame of b: the heading's error moves the origin.
  const Pose2D grid_b_in_grid_a = inverse(kalman.pose_a_in_b);
  const PoseCovariance in_grids = inverseCovariance(kalman.pose_a_in_b, kalman.covariance);
  const Pose2D b_in_grid_a = grid_b_in_grid_a + inverse(b.states.corner_in_map);
  const Eigen::Vector2d arm(b_in_grid_a.x - grid_b_in_grid_a.x, b_in_grid_a.y - grid_b_in_grid_a.y);
  const Eigen::Matrix3d jacobian = turnedAxes(a.states.corner_in_map.phi) * leverTo(arm);
  return jacobian * in_grids * jacobian.transpose();
}

PaperFeatures extract(StateGrid states, const PaperOptions& options) {
  // Section 3.1.1: lines and, eq. 1, vertical points.
  const std::vector<HoughLine> lines = findHoughLines(states, options.hough);
  const std::vector<VerticalPoint> points = findVerticalPoints(lines, options.vertical_points);
  // Section 3.1.2: one point a corner, eq. 2, and those on the outline only.
  const std::vector<PointCluster> corners =
      filterByOutline(states, clusterPoints(points, options.clusters), options.outline);
  // Section 3.1.3: boxes, eq. 3 and Algorithm 1.
  PaperFeatures features;
  features.boxes = buildBoxes(points, corners, options.boxes);
  features.feature_set = describe(states.corner_in_map, lines, corners, features.boxes);
  features.states = std::move(states);
  return features;
}

std::string countOf(const std::optional<BestPair>& best, const PaperFeatures& a,
                    const PaperFeatures& b, const BestPairOptions& options) {
  if (!best) {
    return "no box of one map fits one of the other (" + std::to_string(a.boxes.size()) + " and " +
           std::to_string(b.boxes.size()) + " boxes)";
  }
  return std::to_string(best->agreement.matches.size()) +
         " other pairs of boxes agree with the best pair, " + std::to_string(options.min_agreeing) +
         " are needed";
}

PairResult matchEqualCells(const PaperFeatures& a, const PaperFeatures& b,
                           const PaperOptions& options) {
  PairResult result;
  Stopwatch stopwatch;
  // Section 3.2: rough match, transforms (eq. 4), filter, score (eq. 5).
  const std::optional<BestPair> best = findBestPair(a.boxes, b.boxes, options.best_pair);
  result.seconds.matching = stopwatch.seconds();
  result.reason = countOf(best, a, b, options.best_pair);
  if (!best) {
    return result;
  }
  // Section 3.3: Kalman step, eqs. 6 to 14.
  stopwatch = Stopwatch();
  const KalmanResult kalman =
      refineByKalman(a.states, b.states,
                     matchedBoxes(a.boxes[static_cast<size_t>(best->match.a)],
                                  b.boxes[static_cast<size_t>(best->match.b)], best->shift),
                     best->pose_a_in_b);
  result.seconds.refinement = stopwatch.seconds();

  result.verdict = best->enough ? Verdict::Accepted : Verdict::Rejected;
  result.confidence = best->enough ? kRightWhenAccepted : kRightWhenRejected;
  result.has_pose = true;
  // From the grid frames to the map frames.
  const Pose2D b_in_grid_a = inverse(kalman.pose_a_in_b) + inverse(b.states.corner_in_map);
  result.pose_b_in_a = a.states.corner_in_map + b_in_grid_a;
  result.pose_b_in_a.phi = wrapAngle(result.pose_b_in_a.phi);
  result.covariance = poseCovariance(a, b, kalman);
  result.kalman = result.pose_b_in_a;
  result.matched_boxes.emplace_back(best->match.a, best->match.b);
  for (const RoughMatch& match : best->agreement.matches) {
    result.matched_boxes.emplace_back(match.a, match.b);
  }
  return result;
}

/// The map's own box that lies nearest to one found after resampling, or -1.
int nearestBox(const SuppositionalBox& box, const std::vector<SuppositionalBox>& boxes,
               double largest_distance) {
  int nearest = -1;
  for (size_t i = 0; i < boxes.size(); ++i) {
    const double distance = largestCornerDistance(box, boxes[i], Pose2D());
    if (distance < largest_distance) {
      largest_distance = distance;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

}  // namespace

PaperFeatures extractPaperFeatures(const Map& map, const PaperOptions& options) {
  return extract(classifyCells(map, options.states), options);
}

PairResult matchPaper(const PaperFeatures& a, const PaperFeatures& b, const PaperOptions& options) {
  const double cell_a = a.states.resolution, cell_b = b.states.resolution;
  if (a.states.empty() || b.states.empty() || std::abs(cell_a - cell_b) < 1e-6 * cell_a) {
    return matchEqualCells(a, b, options);
  }
  // Section 3.2 takes maps of one resolution for granted.
  const bool a_is_coarser = cell_a > cell_b;
  const PaperFeatures& coarse = a_is_coarser ? a : b;
  const PaperFeatures fine = extract(resample(coarse.states, std::min(cell_a, cell_b)), options);
  PairResult result =
      a_is_coarser ? matchEqualCells(fine, b, options) : matchEqualCells(a, fine, options);
  std::vector<std::pair<int, int>> matched;
  for (std::pair<int, int> match : result.matched_boxes) {
    int& index = a_is_coarser ? match.first : match.second;
    index = nearestBox(fine.boxes[static_cast<size_t>(index)], coarse.boxes,
                       options.best_pair.agreement.corner_distance);
    if (index >= 0) {
      matched.push_back(match);
    }
  }
  result.matched_boxes = std::move(matched);
  const auto metres = [](double cell) { return numberText(static_cast<float>(cell)) + " m"; };
  result.reason += std::string("; the ") + (a_is_coarser ? "first" : "second") +
                   " map was resampled from " + metres(std::max(cell_a, cell_b)) + " to " +
                   metres(std::min(cell_a, cell_b)) + " cells";
  return result;
}

}  // namespace sbox
