// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a map was made of: where the robot was, and what its sensors saw there. MRPT keeps the same
// in mrpt::maps::CSimpleMap, whose interface differs between versions (see simplemap_file.h).
#pragma once

#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDF.h>

#include <vector>

namespace sbox {

/// One place and what was seen there.
struct KeyFrame {
  mrpt::poses::CPose3DPDF::Ptr robot_in_map;  ///< Never null.
  mrpt::obs::CSensoryFrame::Ptr seen;         ///< Never null.
};

/// What one map was made of, in the order of the drive.
using KeyFrames = std::vector<KeyFrame>;

/// The key frames of a map in the frame of another, in which its own frame has this pose; what was
/// seen is shared, not copied.
[[nodiscard]] KeyFrames moveKeyFrames(const KeyFrames& key_frames,
                                      const mrpt::poses::CPose3D& pose_map_in_reference);

}  // namespace sbox
