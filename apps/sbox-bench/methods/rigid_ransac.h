// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "sbox/core/pose.h"

namespace sbox::bench {

/// A point of map a and the point of map b that it may be, metres.
struct PointMatch {
  Point2D in_a;
  Point2D in_b;
};

struct RansacOptions {
  int draws = 5000;           ///< Pairs of matches tried.
  double tolerance = 0.75;    ///< Distance up to which a match agrees, metres.
  double least_length = 2.0;  ///< Between the two points of a draw, metres: short ones turn freely.
  std::uint32_t seed = 1;
};

struct RansacResult {
  Pose2D pose_b_in_a;
  std::vector<int> inliers;  ///< Indices of the matches that agree; below 2 there is no pose.
};

/// The rigid transform that most matches agree with, fitted to them by least squares. Rotation and
/// translation only: scale is 1 and a mirror image cannot come out. The same matches give the same
/// answer.
[[nodiscard]] RansacResult rigidRansac(const std::vector<PointMatch>& matches,
                                       const RansacOptions& options = {});

}  // namespace sbox::bench
