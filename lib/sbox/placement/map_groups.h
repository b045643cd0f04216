// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which maps belong together. Each map begins as a group of its own; of all pairs of groups, the
// two whose pairs say most surely where they lie to each other are joined, again and again, while
// the evidence suffices.
#pragma once

#include <vector>

#include "sbox/placement/footprint.h"
#include "sbox/placement/pair_evidence.h"
#include "sbox/placement/pose_graph.h"
#include "sbox/placement/settled_group.h"
#include "sbox/verification/verdict.h"

namespace sbox {

/// What evidence joins groups.
struct GroupOptions {
  double min_confidence = 0;   ///< Groups are joined with at least this probability; in [0, 1].
  double overwhelming = 0.99;  ///< Probability from which one pair joins two groups by itself.
  double agreed = 0.95;        ///< Probability from which pairs that agree do, ...
  double witnesses = 1.5;      ///< ... if they are this many; see JoinEvidence.
  double alone = 0.5;          ///< Probability from which an accepted pair adds a single map.
  /// Probability from which a candidate counts as accepted once a guess has spoken: that of the
  /// verdict, which mergeMaps() puts here.
  double accept_from = VerdictOptions().accept_from;
  /// Confidences are probabilities, see weighByBaseRate(): of the default method, says mergeMaps().
  bool is_calibrated = true;
  SamePoseOptions same_pose;  ///< When two poses are one.
  PoseGraphOptions graph;     ///< Of the poses within a group.
};

/// The groups, each with its poses; a map alone is a group. In the order of their first members,
/// which are in ascending order.
[[nodiscard]] std::vector<SettledGroup> groupMaps(const std::vector<Footprint>& maps,
                                                  const std::vector<PairEvidence>& pairs,
                                                  const GroupOptions& options = {});

}  // namespace sbox
