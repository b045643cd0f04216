// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A group's poses and the candidates of its pairs, chosen by each other.
#pragma once

#include <optional>
#include <vector>

#include "sbox/placement/footprint.h"
#include "sbox/placement/pair_evidence.h"
#include "sbox/placement/pose_graph.h"

namespace sbox {

/// A pair whose candidate agrees with the poses of its group.
struct ChosenEdge {
  int pair = 0;       ///< Index of the pair.
  int candidate = 0;  ///< The one that agrees.
  GraphEdge edge;     ///< Between indices into SettledGroup::members.
};

/// The poses of some maps in one frame, and what holds them there.
struct SettledGroup {
  std::vector<int> members;       ///< Indices of maps.
  std::vector<Pose2D> poses;      ///< Of the members, in the frame of the group.
  std::vector<ChosenEdge> edges;  ///< In the order of the pairs.
  PoseGraphSolution solution;     ///< Of these edges.

  /// Whether the edges leave no member unconnected.
  [[nodiscard]] bool isConnected() const;
  /// The transforms of the edges, in their order.
  [[nodiscard]] std::vector<GraphEdge> graphEdges() const;
};

/// The candidate that is likely and near the pose; none if no candidate agrees with it.
[[nodiscard]] std::optional<int> chooseCandidate(const PairEvidence& pair, const Footprint& a,
                                                 const Footprint& b, const Pose2D& pose_b_in_a,
                                                 const SamePoseOptions& options);

/// Chooses each pair's candidate by the poses, and solves for the poses by those chosen, in turns
/// until neither changes. `poses` is where the members start; the first stays.
[[nodiscard]] SettledGroup settleGroup(std::vector<int> members, std::vector<Pose2D> poses,
                                       const std::vector<PairEvidence>& pairs,
                                       const std::vector<Footprint>& maps,
                                       const SamePoseOptions& same_pose,
                                       const PoseGraphOptions& graph);

}  // namespace sbox
