// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Iterative closest points between the walls of two maps: each wall point is drawn to the line of
// the nearest wall of the other map that faces the same way, in both directions at once.
#pragma once

#include "sbox/core/rigid_transform.h"
#include "sbox/features/map_features.h"

namespace sbox {

/// How walls are laid on walls.
struct AlignmentOptions {
  double kernel = 1.25;  ///< Scale of the robust kernel, metres: walls further off count little.
  int iterations = 20;   ///< At most.
  size_t most_points = 1500;  ///< Wall points used of each map.
};

/// The transform improved from `start` by Gauss-Newton with a Geman-McClure kernel.
[[nodiscard]] RigidTransform alignWalls(const MapFeatures& a, const MapFeatures& b,
                                        const RigidTransform& start,
                                        const AlignmentOptions& options = {});

/// How firmly the walls fix the transform: sum of J^T J over a metre of agreeing wall each, J being
/// the derivative of a wall's offset by (x, y, heading) of the middle of map b in map a.
[[nodiscard]] Eigen::Matrix3d wallInformation(const MapFeatures& a, const MapFeatures& b,
                                              const RigidTransform& b_in_a,
                                              const AlignmentOptions& options = {});

}  // namespace sbox
