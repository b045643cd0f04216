// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CRawlog.h>

#include <string>

#include "sbox-dataset/run.h"

namespace sbox::dataset {

/// Writes a run as MRPT's SLAM reads it: for each step an action with the odometry since the last
/// step, which is what `pose_in_map` says of it, and a sensory frame with the scan; time stamps
/// five a second. Throws std::runtime_error if the file cannot be written.
void saveRawlog(const Run& run, const std::string& path);

/// Writes where the robot was in truth, a line "index x y phi" a step, in metres and radians, in
/// the world frame. Throws std::runtime_error if the file cannot be written.
void saveTruePoses(const Run& run, const std::string& path);

/// The steps of a run as pairs of action and sensory frame.
[[nodiscard]] mrpt::obs::CRawlog rawlogOf(const Run& run);

}  // namespace sbox::dataset
