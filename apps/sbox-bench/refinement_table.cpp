// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/refinement_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "sbox-bench/judge.h"
#include "sbox-bench/statistics.h"
#include "sbox/core/parallel.h"
#include "sbox/core/rigid_fit.h"
#include "sbox/match_pair.h"
#include "sbox/paper/kalman_step.h"
#include "sbox/refinement/corner_pairs.h"
#include "sbox/refinement/mean_transform.h"

namespace sbox::bench {
namespace {

enum Way { BestBoxes, PaperKalman, LeastSquares, Kalman, Ceres, MeanDrift, Reported };
constexpr size_t kWays = Reported + 1;
constexpr std::array<const char*, kWays> kNames = {"best pair of boxes",
                                                   "its Kalman step (paper)",
                                                   "least squares",
                                                   "Kalman",
                                                   "Ceres",
                                                   "mean drift",
                                                   "reported"};

/// The pose of grid b in grid a by each way, if it gives one.
using Poses = std::array<std::optional<Pose2D>, kWays>;

Point2D toPoint(const Eigen::Vector2d& point) { return {point.x(), point.y()}; }

Pose2D toPose(const RigidTransform& transform) {
  return {transform.translation.x(), transform.translation.y(), transform.heading};
}

/// Sum of the distances between corners of a and those of b under the pose.
double distanceSum(const std::vector<CornerPair>& corners, const Pose2D& b_in_a) {
  const Transform to_a(b_in_a);
  double sum = 0;
  for (const CornerPair& corner : corners) {
    sum += (to_a(toPoint(corner.in_b)) - toPoint(corner.in_a)).norm();
  }
  return sum;
}

void addBoxPoses(const std::vector<BoxMatch>& boxes, const std::vector<CornerPair>& corners,
                 const StateGrid& grid_a, const StateGrid& grid_b, Poses& poses) {
  double least = std::numeric_limits<double>::infinity();
  for (const BoxMatch& match : boxes) {
    MatchedBoxes matched;
    std::vector<Point2D> from, to;
    for (size_t i = 0; i < 4; ++i) {
      matched.corners_a[i] = toPoint(match.corners_a[i]);
      matched.corners_b[i] = toPoint(match.corners_b[i]);
      from.push_back(matched.corners_b[i]);
      to.push_back(matched.corners_a[i]);
    }
    // As the paper's transform T: from three of the corners.
    from.pop_back();
    to.pop_back();
    const Pose2D b_in_a = fitRigid(from, to);
    const double sum = distanceSum(corners, b_in_a);
    if (sum < least) {
      least = sum;
      poses[BestBoxes] = b_in_a;
      poses[PaperKalman] =
          inverse(refineByKalman(grid_a, grid_b, matched, inverse(b_in_a)).pose_a_in_b);
    }
  }
  if (!corners.empty()) {
    std::vector<Point2D> from, to;
    for (const CornerPair& corner : corners) {
      from.push_back(toPoint(corner.in_b));
      to.push_back(toPoint(corner.in_a));
    }
    poses[LeastSquares] = fitRigid(from, to);
  }
}

Poses refineAllWays(const MapFeatures& a, const MapFeatures& b, const Fit& fit,
                    const StateGrid& grid_a, const StateGrid& grid_b, const PairOptions& options) {
  Poses poses;
  const std::vector<BoxMatch> boxes = matchBoxes(a, b, fit.b_in_a, fit.drift, options.boxes);
  const std::vector<CornerPair> corners = uniqueCorners(boxes, options.refine.kalman.corner_noise);
  addBoxPoses(boxes, corners, grid_a, grid_b, poses);
  const RefinedPose refined = refinePose(a, b, fit.b_in_a, fit.drift, boxes, options.refine);
  if (refined.kalman) {
    poses[Kalman] = toPose(*refined.kalman);
  }
  if (refined.ceres) {
    poses[Ceres] = toPose(*refined.ceres);
  }
  poses[MeanDrift] = toPose(meanTransform(a, b, fit.b_in_a, fit.drift));
  poses[Reported] = toPose(refined.b_in_a);
  return poses;
}

double quantile90(std::vector<double> values) {
  if (values.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(0.9 * static_cast<double>(values.size() - 1))];
}

/// Excess in cells of each way for one pair; empty where its best fit is wrong.
using Excesses = std::array<std::optional<double>, kWays>;

Excesses excessesOf(const LoadedFolder& loaded, size_t pair,
                    const std::vector<MapFeatures>& features, const std::vector<StateGrid>& grids) {
  const PairOptions options;
  const auto a = static_cast<size_t>(loaded.map_of_pair[pair].first);
  const auto b = static_cast<size_t>(loaded.map_of_pair[pair].second);
  Excesses excesses;
  PairSeconds seconds;
  const std::vector<Fit> fits = findAnswers(features[a], features[b], options, seconds);
  if (fits.empty() || loaded.folder.pairs[pair].negative) {
    return excesses;
  }
  const Poses poses =
      refineAllWays(features[a], features[b], fits.front(), grids[a], grids[b], options);
  std::array<std::optional<PoseError>, kWays> errors;
  for (size_t way = 0; way < kWays; ++way) {
    if (poses[way]) {
      const RigidTransform transform{poses[way]->phi, {poses[way]->x, poses[way]->y}};
      const Pose2D pose = framePose(features[a], features[b], transform);
      errors[way] = poseError(
          loaded.folder.pairs[pair], loaded.folder.resolution,
          cornerTransform(pose, loaded.maps[a].corner_in_map, loaded.maps[b].corner_in_map));
    }
  }
  if (errors[Reported] && errors[Reported]->right) {
    for (size_t way = 0; way < kWays; ++way) {
      if (errors[way]) {
        excesses[way] = errors[way]->excess_cells;
      }
    }
  }
  return excesses;
}

}  // namespace

Table refinementTable(const std::vector<LoadedFolder>& folders, int threads) {
  Table table{{"excess over the floor, cells: median (90 %)", "pairs"}, {}};
  table.header.insert(table.header.end(), kNames.begin(), kNames.end());
  for (const LoadedFolder& loaded : folders) {
    std::vector<MapFeatures> features(loaded.maps.size());
    std::vector<StateGrid> grids(loaded.maps.size());
    parallelFor(static_cast<int>(features.size()), threads, [&](int i) {
      const auto k = static_cast<size_t>(i);
      features[k] = extractFeatures(loaded.maps[k]);
      grids[k] = classifyCells(loaded.maps[k]);
    });
    std::vector<Excesses> of_pair(loaded.folder.pairs.size());
    parallelFor(static_cast<int>(of_pair.size()), threads, [&](int i) {
      const auto k = static_cast<size_t>(i);
      of_pair[k] = excessesOf(loaded, k, features, grids);
    });
    std::array<std::vector<double>, kWays> of_way;
    for (const Excesses& excesses : of_pair) {
      for (size_t way = 0; way < kWays; ++way) {
        if (excesses[way]) {
          of_way[way].push_back(*excesses[way]);
        }
      }
    }
    std::vector<std::string> row{loaded.folder.name, std::to_string(of_way[Reported].size())};
    for (const std::vector<double>& values : of_way) {
      row.push_back(formatNumber(median(values), 2) + " (" + formatNumber(quantile90(values), 2) +
                    ")");
    }
    if (!of_way[Reported].empty()) {
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace sbox::bench
