// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/adjustment/scan_points.h"
#include "sbox/core/key_frame.h"
#include "sbox/core/map.h"

namespace sbox {

/// How sharp a map of scans is: the share of what they saw (scanPoints) that lies where the map is
/// occupied. Where key frames contradict each other, some see through what others saw. 0 where
/// nothing was seen.
[[nodiscard]] double scanAgreement(const KeyFrames& key_frames, const Map& map,
                                   const ScanPointOptions& options = {});

}  // namespace sbox
