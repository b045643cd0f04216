// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Least squares by Ceres, which the Kalman step checks: the corners of all agreeing boxes
// and the walls of both maps at once, under a robust loss whose scale shrinks from round to round.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "sbox/core/rigid_transform.h"
#include "sbox/features/map_features.h"
#include "sbox/refinement/corner_pairs.h"

namespace ceres {
class CostFunction;
}

namespace sbox {

/// Options of the least squares.
struct PolishOptions {
  double first_scale = 0.6;    ///< Of the robust loss in the first round, metres; ...
  double last_scale = 0.15;    ///< ... it shrinks to this in the last.
  int rounds = 3;              ///< Walls are paired anew in each.
  int iterations = 50;         ///< At most, a round.
  size_t most_points = 400;    ///< Wall points used of each map.
  size_t most_corners = 100;   ///< Corners used.
  double corner_weight = 0.1;  ///< Of all corners together, as a share of all walls.
  double corner_noise = 0.25;  ///< Standard deviation of a corner that counts fully, metres.
};

/// The transform that fits corners and walls best, from `start`; none if no wall of one map lies
/// near one of the other. `pivot_b`: the point of map b, in its grid frame, about which the heading
/// is taken.
[[nodiscard]] std::optional<RigidTransform> polishByCeres(
    const MapFeatures& a, const MapFeatures& b, const std::vector<CornerPair>& corners,
    const RigidTransform& start, const Eigen::Vector2d& pivot_b, const PolishOptions& options = {});

/// A wall point of each map; both grid frames.
struct WallPair {
  WallPoint a;  ///< Of map a.
  WallPoint b;  ///< Of map b.
};

/// What should lie on what.
struct PolishPairs {
  std::vector<WallPair> on_lines_of_a;  ///< The point of b on the line of the wall of a.
  std::vector<WallPair> on_lines_of_b;  ///< The point of a on the line of the wall of b.
  std::vector<CornerPair> corners;      ///< On each other.
  double corner_noise = PolishOptions().corner_noise;  ///< As in the options.
  double corner_weight = 0;  ///< Of each corner over that of a pair of walls.
};

/// Residuals over the parameters (x, y, heading) of the pivot in map a, in the order of the pairs:
/// the distance of each wall point from its line, and two for the offset of each pair of corners,
/// weighed along its axes by 1 / standard deviation relative to `corner_noise`; metres. Each so
/// scaled down that half its square is half of Geman and McClure's loss of this scale (metres),
/// which is never more than scale^2 (times the weight). Goes to a ceres::Problem, which owns it.
[[nodiscard]] ceres::CostFunction* createPolishCost(const PolishPairs& pairs,
                                                    const Eigen::Vector2d& pivot_b, double scale);

}  // namespace sbox
