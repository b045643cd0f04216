// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/core/key_frame.h"

namespace sbox {

/// Replaces poses that are sets of particles (one for each path that RBPF-SLAM still believes in,
/// in the same order at every key frame) by Gaussians: the mean is where the likeliest path passes,
/// since the mean of all paths is on none of them; the covariance is that of the set.
[[nodiscard]] KeyFrames keepBestParticle(const KeyFrames& key_frames);

}  // namespace sbox
