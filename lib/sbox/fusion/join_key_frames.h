// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins placed maps by what the robots saw instead of by cells: mapKeyFrames of the result is the
// merged map made anew. No cell is resampled, so walls stay as sharp as the scans draw them.
#pragma once

#include <vector>

#include "sbox/core/key_frame.h"
#include "sbox/core/pose.h"

namespace sbox {

/// The key frames of a map and where it goes; it does not own them.
struct PlacedKeyFrames {
  const KeyFrames* key_frames = nullptr;  ///< Of the map, in its frame.
  Pose2D pose_in_reference;               ///< Frame of the map in the frame of the reference map.
};

/// The key frames of all maps, map by map, in the frame of the reference. What was seen is shared,
/// not copied. Throws std::invalid_argument if a map's are missing.
[[nodiscard]] KeyFrames joinKeyFrames(const std::vector<PlacedKeyFrames>& maps);

}  // namespace sbox
