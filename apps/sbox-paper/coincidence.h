// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Figure 8's measure: how much of the wall edges that both maps show lies twice in the merged map.
#pragma once

#include "sbox-paper/robot_pair.h"

namespace sbox::paper {

struct CoincidenceOptions {
  double spacing = 0.05;       ///< Between the places along an edge that are looked at, metres.
  double least_edge = 0.5;     ///< Shorter edges of the world are not counted, metres.
  double search = 0.4;         ///< How far off its true place a map's wall may lie, metres.
  double least_visible = 0.5;  ///< An edge counts if both maps show so much of it, metres.
  double apart = 0.1;          ///< Walls further apart do not touch: they are seen twice, metres.
};

struct Coincidence {
  int edges = 0;        ///< Edges that both maps show.
  int apart_edges = 0;  ///< Those of them that lie apart over more than half their length.
  double length = 0;    ///< Metres of edge that both maps show.
  double apart = 0;     ///< Metres of it where the two maps' walls lie apart.
  double mean_gap = 0;  ///< Mean distance between the two maps' walls, metres.

  /// Share of the length that does not coincide, 0 if nothing is shared.
  [[nodiscard]] double share() const { return length > 0 ? apart / length : 0; }
};

/// Takes map b into map a by the pose and looks along each edge of the world, from the side that
/// was driven on, where each map has its wall.
[[nodiscard]] Coincidence wallCoincidence(const RobotPair& pair, const Pose2D& pose_b_in_a,
                                          const CoincidenceOptions& options = {});

}  // namespace sbox::paper
