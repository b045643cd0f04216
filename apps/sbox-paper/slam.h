// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's SLAM over a robot's run: where the robot itself comes to believe it was.
#pragma once

#include <cstdint>

#include "sbox-dataset/run.h"

namespace sbox::paper {

/// The run with `pose_in_map` as MRPT's ICP-SLAM corrects it from odometry and scans.
[[nodiscard]] dataset::Run slamByIcp(const dataset::Run& odometry_run);

/// The run with `pose_in_map` as MRPT's RBPF-SLAM corrects it: a particle filter over maps with
/// scan matching in its proposal, the algorithm of Gmapping. Draws from MRPT's global random
/// generator, which it seeds: not to be called from two threads at once.
[[nodiscard]] dataset::Run slamByRbpf(const dataset::Run& odometry_run, std::uint32_t seed);

}  // namespace sbox::paper
