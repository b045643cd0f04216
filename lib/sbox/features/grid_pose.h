// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/core/pose.h"
#include "sbox/features/map_features.h"

namespace sbox {

/// Grid frame of map b in that of map a, for maps whose own frames have these poses in a third one.
[[nodiscard]] inline Pose2D gridPose(const MapFeatures& a, const Pose2D& pose_a,
                                     const MapFeatures& b, const Pose2D& pose_b) {
  return inverse(pose_a + a.grid_in_map) + pose_b + b.grid_in_map;
}

}  // namespace sbox
