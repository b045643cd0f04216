// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's `.rawlog` files, brought into the one form that its SLAM classes all take: pairs of what
// the robot did and what it then saw.
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <string>
#include <vector>

namespace sbox {

/// One entry of a robot's log.
struct LogStep {
  /// One planar movement since the step before; none where the log has no odometry.
  mrpt::obs::CActionCollection::Ptr moved;
  mrpt::obs::CSensoryFrame::Ptr seen;  ///< One or more 2D lidar scans, and what came with them.
};

/// A robot's log.
struct ScanLog {
  std::vector<LogStep> steps;  ///< In the order of the log.
  bool has_odometry = false;   ///< Whether the steps tell how the robot moved.
  bool cut_off = false;        ///< The file ends, or is damaged, in the midst of an entry.
};

/// Reads a `.rawlog` or `.rawlog.gz`, whether it holds pairs of actions and sensory frames or bare
/// observations. Bare scans of several lidars at one time make one step; odometry is interpolated
/// to the time of each scan. Steps without 2D scans are left out, their movement is not. Of a
/// damaged file all that comes before the damage is taken. Throws FileError, also if there is no 2D
/// scan, one that is not sound (see isSound()), or a movement beyond measure.
[[nodiscard]] ScanLog loadScanLog(const std::string& path);

}  // namespace sbox
