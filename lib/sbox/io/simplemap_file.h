// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's `.simplemap` files, and the only place that touches mrpt::maps::CSimpleMap: MRPT 2.11.5
// rewrote the class. What is used here is the part that both forms share.
#pragma once

#include <mrpt/maps/CSimpleMap.h>

#include <string>

#include "sbox/core/key_frame.h"

namespace sbox {

/// Reads a `.simplemap` or `.simplemap.gz`; compressed or not is seen from its contents. Throws
/// FileError, also if a pose is missing or not finite.
[[nodiscard]] KeyFrames loadKeyFrames(const std::string& path);

/// Writes a gzip-compressed file in the version that the MRPT in use writes: what MRPT 2.11.5 and
/// later write, earlier ones cannot read. Throws FileError.
void saveKeyFrames(const KeyFrames& key_frames, const std::string& path);

/// The key frames of an MRPT map; nothing is copied but the pointers. Throws std::invalid_argument
/// if a pose or a frame is missing, or a pose is not finite.
[[nodiscard]] KeyFrames keyFramesOf(const mrpt::maps::CSimpleMap& map);

}  // namespace sbox
