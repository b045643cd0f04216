// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All maps at once: which belong together (map_groups.h), and where each lies by all pairs of its
// group (pose_graph.h). A pair that alone was ambiguous or wrong is settled by the others.
#pragma once

#include <optional>
#include <vector>

#include "sbox/core/pose.h"
#include "sbox/placement/footprint.h"
#include "sbox/placement/initial_guess.h"
#include "sbox/placement/map_groups.h"
#include "sbox/placement/map_pair.h"

namespace sbox {

/// What joins maps, and how their poses are solved for.
using PlacementOptions = GroupOptions;

/// Where a map lies.
struct MapPlacement {
  int group = 0;  ///< Maps that belong together share it; a map alone has its own.
  Pose2D pose;    ///< Frame of the map in the frame of its group's reference.
  PoseCovariance covariance =
      PoseCovariance::Zero();  ///< Of the pose; zero for the reference only.
  int reference = 0;           ///< The map whose frame that is: of a map alone, itself.
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
  /// What became of each pair, in the order given; see MapPair::settlement.
  std::vector<std::optional<PairSettlement>> settlements;
  /// The maps that lie elsewhere in their group than their guesses say, beside the map with whose
  /// guess most others agree.
  std::vector<OverruledGuess> overruled;
};

/// Places maps of these footprints. A group's reference is `reference` where it is a member, else
/// its first member. The order of the pairs changes nothing. `guesses` break ties. Throws
/// std::invalid_argument when an index is out of range or no map is given.
[[nodiscard]] PlacementResult placeMaps(const std::vector<Footprint>& maps,
                                        const std::vector<MapPair>& pairs,
                                        std::optional<int> reference = {},
                                        const PlacementOptions& options = {},
                                        const std::vector<InitialGuess>& guesses = {});

}  // namespace sbox
