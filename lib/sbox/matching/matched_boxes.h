// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The boxes of two maps that lie on each other under a transform (section 3.2: the filter).
#pragma once

#include <utility>
#include <vector>

#include "sbox/alignment/drift_field.h"
#include "sbox/core/rigid_transform.h"
#include "sbox/features/map_features.h"

namespace sbox {

/// Two boxes and which corners of them lie on each other.
struct BoxMatch {
  int a = 0;  ///< Index into the boxes of all frames of map a, in the order of its feature set.
  int b = 0;  ///< The same for map b.
  std::array<Eigen::Vector2d, 4> corners_a;  ///< In the grid frame of map a, metres.
  std::array<Eigen::Vector2d, 4> corners_b;  ///< In the grid frame of map b; corner i lies on i.
};

/// When two boxes are one.
struct BoxMatchOptions {
  double corner_distance = 0.5;  ///< All four corners lie this near, metres.
};

/// For each box of b the box of a with the same sides that lies nearest, where all corners agree
/// once the drift is taken out. A box of a may serve several.
[[nodiscard]] std::vector<BoxMatch> matchBoxes(const MapFeatures& a, const MapFeatures& b,
                                               const RigidTransform& b_in_a,
                                               const DriftField& drift,
                                               const BoxMatchOptions& options = {});

}  // namespace sbox
