// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/poses/CPose2D.h>

namespace sbox {

/// One action: the robot moved by `increment` (metres, radians, in its own frame) until `time`, as
/// surely as the model of its odometry says.
[[nodiscard]] mrpt::obs::CActionCollection::Ptr planarMovement(
    const mrpt::poses::CPose2D& increment,
    const mrpt::obs::CActionRobotMovement2D::TMotionModelOptions& model,
    mrpt::Clock::time_point time);

}  // namespace sbox
