// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the cells of two maps say of a transform: how much wall of one stands on wall of the other
// that faces the same way, how much stands where the other saw free space, and how much free space
// they share.
#pragma once

#include <array>
#include <limits>

#include "sbox/alignment/drift_field.h"
#include "sbox/alignment/room_tally.h"
#include "sbox/alignment/wall_sums.h"
#include "sbox/core/rigid_transform.h"
#include "sbox/features/map_features.h"

namespace sbox {

/// What counts as agreement and as conflict.
struct EvidenceOptions {
  double kernel = 0.5;         ///< Standard deviation at which walls agree, metres.
  double conflict_from = 0.3;  ///< Depth in free space at which a wall begins to conflict, metres.
  double conflict_full = 1.0;  ///< Depth from which it conflicts fully, metres.
  /// Length of line from which a wall counts as straight, metres. Shorter ones are mostly furniture
  /// and people, which come and go.
  double straight_from = 1.0;
  /// Depth up to which a wall in conflict, and free space, are shallow, metres. Drift may have
  /// carried a wall so far ...
  double shallow_until = 2.0;
  double deep_from = 2.5;  ///< ... and hardly so deep, metres; what lies between tells little.
  double deep_full = 3.5;  ///< Depth from which a wall counts fully as deep, metres.
};

/// Sums over both maps, each map's walls counted once.
struct Overlap : WallSums {
  double free_free = 0;  ///< Area free in both, square metres (mean of both counts).
};

/// All that is counted.
struct Evidence : Overlap {
  WallSums straight;  ///< Of the straight walls alone; the rest is clutter.
  /// Of straight walls in conflict, those in shallow free space, where drift may have carried them
  /// (EvidenceOptions::shallow_until), ...
  double shallow_conflict = 0;
  /// ... and those so deep that it has not, see deepWeight().
  double deep_conflict = 0;
  /// Agreeing wall by the direction it faces: the sum of agree n n^T over unit normals n in map a.
  /// A small eigenvalue means that walls hardly fix the shift along its direction.
  Eigen::Matrix2d facing = Eigen::Matrix2d::Zero();
  RoomCounts rooms;  ///< Counted only once the drift is taken out.
  /// What of `free_free` is shallow in one of the maps, square metres: the middle of a hall is free
  /// in every hall.
  double free_shallow = 0;
};

/// Weight of a wall this deep (metres) in free space as a conflict, from 0 to 1.
[[nodiscard]] double conflictWeight(double depth, const EvidenceOptions& options);
/// The same as a deep one.
[[nodiscard]] double deepWeight(double depth, const EvidenceOptions& options);

/// The weights of the options by quantised distance or depth (see WallFields), made once for many
/// hypotheses.
struct EvidenceWeights {
  /// The weights of the options.
  EvidenceWeights(const EvidenceOptions& options = {});  // NOLINT: options serve where weights do.

  std::array<double, 256> agree{};     ///< Of a wall this far off, see EvidenceOptions::kernel.
  std::array<double, 256> conflict{};  ///< See conflictWeight().
  std::array<double, 256> shallow{};   ///< Of a conflict up to EvidenceOptions::shallow_until.
  std::array<double, 256> deep{};      ///< See deepWeight().
  double straight_from = 0;            ///< See EvidenceOptions::straight_from.
  double shallow_until = 0;            ///< See EvidenceOptions::shallow_until.
};

/// As `most_points`: asks all of them.
constexpr size_t kAllPoints = std::numeric_limits<size_t>::max();

/// What gatherEvidence() finds in common, for less time: for many hypotheses.
[[nodiscard]] Overlap measureOverlap(const MapFeatures& a, const MapFeatures& b,
                                     const RigidTransform& b_in_a, size_t most_points = kAllPoints,
                                     const EvidenceWeights& weights = {});

/// Asks the first `most_points` wall points (and as many free points) of each map; sums are scaled
/// up to all of them.
[[nodiscard]] Evidence gatherEvidence(const MapFeatures& a, const MapFeatures& b,
                                      const RigidTransform& b_in_a, size_t most_points = kAllPoints,
                                      const EvidenceWeights& weights = {});

/// The same once the drift between the maps is taken out.
[[nodiscard]] Evidence gatherEvidence(const MapFeatures& a, const MapFeatures& b,
                                      const RigidTransform& b_in_a, const DriftField& drift,
                                      size_t most_points = kAllPoints,
                                      const EvidenceWeights& weights = {});

}  // namespace sbox
