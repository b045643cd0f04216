// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/key_frame.h"

#include <memory>

namespace sbox {

KeyFrames moveKeyFrames(const KeyFrames& key_frames,
                        const mrpt::poses::CPose3D& pose_map_in_reference) {
  KeyFrames moved;
  moved.reserve(key_frames.size());
  for (const KeyFrame& key_frame : key_frames) {
    const mrpt::rtti::CObject::Ptr copy = key_frame.robot_in_map->duplicateGetSmartPtr();
    const auto pose = std::dynamic_pointer_cast<mrpt::poses::CPose3DPDF>(copy);
    pose->changeCoordinatesReference(pose_map_in_reference);
    moved.push_back({pose, key_frame.seen});
  }
  return moved;
}

}  // namespace sbox
