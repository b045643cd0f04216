// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a pair of maps says of where they lie, in the terms of placement: transforms that exclude
// each other, each with a probability, and the probability that none of them is right.
#pragma once

#include <vector>

#include "sbox/core/pose.h"
#include "sbox/placement/footprint.h"
#include "sbox/placement/map_pair.h"

namespace sbox {

/// A transform that a pair proposes.
struct EdgeCandidate {
  Pose2D pose_b_in_a;         ///< Frame of map b in the frame of map a.
  PoseCovariance covariance;  ///< Of the pose if it is right; positive definite.
  double probability = 0;     ///< That it is right; above 0.
};

/// A pair's proposals.
struct PairEvidence {
  int a = 0;                              ///< Index of the first map.
  int b = 0;                              ///< Index of the second map.
  int accepted = -1;                      ///< The candidate that was accepted; -1: none.
  std::vector<EdgeCandidate> candidates;  ///< As PairSettlement::candidate counts them.
  double none = 1;                        ///< Probability that no candidate is right; above 0.
};

/// When two poses of one map count as the same, in spite of drift.
struct SamePoseOptions {
  double distance = 1.0;         ///< Of the maps' middles, metres ...
  double distance_share = 0.05;  ///< ... plus this share of their mean radius.
  double turn = 0.1047;          ///< Between headings, radians.
};

/// Whether the gap is small enough for maps of these footprints.
[[nodiscard]] bool isSamePose(const PoseGap& gap, const Footprint& a, const Footprint& b,
                              const SamePoseOptions& options);

/// Log of how much likelier a candidate is to be right once something else proposes the same pose:
/// wrong ones seldom agree by chance.
inline constexpr double kLogCoincidence = 3;

/// The probability that a candidate is right, given that it agrees with other evidence; 1 for what
/// was accepted.
[[nodiscard]] double trustOnAgreement(const PairEvidence& pair, int candidate);

/// The pair in the terms of placement. Alternatives have no covariance of their own: they take the
/// first candidate's, as that of the maps' middles.
[[nodiscard]] PairEvidence evidenceOf(const MapPair& pair, const Footprint& a, const Footprint& b);

/// Scales the probabilities of the candidates and of none to a sum of 1.
void normalise(PairEvidence& pair);

/// Lowers the probabilities to what they are among so many pairs: a pair's own are those where half
/// of all pairs belong together, and of a fleet's pairs most do not. The share that does is learnt
/// from the pairs themselves (expectation maximisation); it never raises a probability.
void weighByBaseRate(std::vector<PairEvidence>& pairs);

}  // namespace sbox
