// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What all pairs between two groups say together of how the groups lie to each other.
#pragma once

#include <optional>
#include <vector>

#include "sbox/placement/footprint.h"
#include "sbox/placement/pair_evidence.h"

namespace sbox {

/// A pair of which one map belongs to either group.
struct CrossPair {
  const PairEvidence* pair = nullptr;  ///< What it proposes, for its own a and b.
  bool turned = false;                 ///< Its map a belongs to the second group.
  Pose2D pose_a_in_group;              ///< Its map a in the frame of that map's group.
  Pose2D pose_b_in_group;              ///< Its map b in the frame of that map's group.
};

/// The best way to lay one group to another.
struct JoinEvidence {
  Pose2D second_in_first;  ///< Frame of the second group in that of the first.
  double log_odds = 0;     ///< For this pose against the groups having nothing in common.
  double probability = 0;  ///< Of this pose, and not another or none.
  double strongest = 0;    ///< Probability of the likeliest candidate that agrees with it, alone.
  bool accepted = false;   ///< That candidate was accepted.
  /// Pairs that speak for this pose, as far as they speak of places that likelier ones do not: two
  /// that mistake the same room for the same other room are one witness.
  double witnesses = 0;
};

/// Nothing if no pair proposes a pose worth a look. The order of the pairs changes nothing but
/// rounding.
[[nodiscard]] std::optional<JoinEvidence> weighJoin(const std::vector<CrossPair>& pairs,
                                                    const std::vector<Footprint>& maps,
                                                    const SamePoseOptions& same_pose);

}  // namespace sbox
