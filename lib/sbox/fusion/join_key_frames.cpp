// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/fusion/join_key_frames.h"

#include <mrpt/poses/CPose3D.h>

#include <stdexcept>

namespace sbox {

KeyFrames joinKeyFrames(const std::vector<PlacedKeyFrames>& maps) {
  KeyFrames all;
  for (const PlacedKeyFrames& placed : maps) {
    if (placed.key_frames == nullptr) {
      throw std::invalid_argument("a map without key frames cannot be joined by them");
    }
    const mrpt::poses::CPose3D pose_map_in_reference(mrpt::math::TPose3D(placed.pose_in_reference));
    const KeyFrames moved = moveKeyFrames(*placed.key_frames, pose_map_in_reference);
    all.insert(all.end(), moved.begin(), moved.end());
  }
  return all;
}

}  // namespace sbox
