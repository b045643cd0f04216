// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The truth about two runs in one world: where the same places lie in the two robots' maps.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sbox-dataset/run.h"

namespace sbox::dataset {

struct PairTruth {
  /// Places that both robots saw, in the frame of map a and in that of map b.
  std::vector<std::pair<Point2D, Point2D>> places;
  Pose2D pose_b_in_a;  ///< The best rigid fit of the places, by least squares.
  double rms = 0;      ///< What that fit leaves of them, in metres.
  double overlap = 0;  ///< Known area in common, share of the smaller map's known area.
};

struct TruthOptions {
  size_t count = 60;     ///< Places to find at most.
  double spacing = 0.5;  ///< One place in a square of this edge length, in metres.
  double radius = 0.05;  ///< A place is where both robots have scan points so close, in metres.
};

/// Finds places that both robots saw and how they fit; nothing if there are fewer than two.
[[nodiscard]] std::optional<PairTruth> findTruth(const Run& run_a, const Run& run_b,
                                                 const Map& map_a, const Map& map_b,
                                                 const TruthOptions& options = {});

}  // namespace sbox::dataset
