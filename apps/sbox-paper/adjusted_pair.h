// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox-paper/robot_pair.h"

namespace sbox::paper {

/// The pair after `sbox-merge --fusion observations`: all scans of both robots adjusted together
/// from where `pose_b_in_a` puts them. Both runs and both maps are in the frame of map 1, so that
/// map 2 goes into map 1 by the identity. The truth is left out: it is of the maps before.
[[nodiscard]] RobotPair adjustedPair(const RobotPair& pair, const Pose2D& pose_b_in_a);

/// The one map of all scans of both runs, at the poses that these have in map 1's frame.
[[nodiscard]] Map mapOfBoth(const RobotPair& adjusted);

}  // namespace sbox::paper
