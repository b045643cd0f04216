// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All maps at once: which belong together, and where each lies. Accepted pairs, the most confident
// first, join groups of maps (a maximum-confidence spanning tree); poses are composed along the
// tree.
#pragma once

#include <optional>
#include <vector>

#include "sbox/core/pair_result.h"
#include "sbox/core/pose.h"

namespace sbox {

/// What is known about the maps with the indices a and b; a < b.
struct MapPair {
  int a = 0;          ///< Index of the first map.
  int b = 0;          ///< Index of the second map.
  PairResult result;  ///< What matching them gave.
};

/// Which pairs join maps.
struct PlacementOptions {
  double min_confidence = 0;  ///< Accepted pairs below this confidence join nothing; in [0, 1].
};

/// Where a map lies.
struct MapPlacement {
  int group = 0;  ///< Maps that belong together share it; a map alone has its own.
  Pose2D pose;    ///< Frame of the map in the frame of its group's reference.
  PoseCovariance covariance =
      PoseCovariance::Zero();  ///< Of the pose; zero for the reference only.
};

/// Maps that belong together.
struct MapGroup {
  int reference = 0;         ///< The map whose frame the poses of the group are in.
  std::vector<int> members;  ///< In ascending order; includes the reference.
};

/// Where all maps lie.
struct PlacementResult {
  std::vector<MapPlacement> maps;  ///< In the order of the input.
  std::vector<MapGroup> groups;    ///< By number: in the order of their first members.
  int largest = 0;                 ///< The group with most members; of equals the first.
};

/// Places `map_count` maps. A group's reference is `reference` where it is a member, else its first
/// member. The order of the pairs changes nothing. Throws std::invalid_argument when an index is
/// out of range or no map is given.
[[nodiscard]] PlacementResult placeMaps(int map_count, const std::vector<MapPair>& pairs,
                                        std::optional<int> reference = {},
                                        const PlacementOptions& options = {});

}  // namespace sbox
