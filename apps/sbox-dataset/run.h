// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a robot did: where it was, where it thought it was, and what its lidar saw.
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <string>
#include <vector>

#include "sbox/mapping/map_key_frames.h"

namespace sbox::dataset {

struct RunStep {
  Pose2D pose_in_world;  ///< Where the robot is: the truth, or the best that is known of it.
  Pose2D pose_in_map;    ///< Where the robot's own SLAM or odometry puts it.
  mrpt::obs::CObservation2DRangeScan scan;
};

using Run = std::vector<RunStep>;

/// A run, and where it was.
struct NamedRun {
  std::string name;
  std::string place;  ///< The building; runs of different places have nothing in common.
  Run steps;
};

/// Every scan of the run at the robot's own pose.
[[nodiscard]] KeyFrames keyFramesOf(const Run& run);

/// The grid that MRPT's log-odds mapping makes of the scans at the robot's own poses, cropped to
/// the cells it knows.
[[nodiscard]] Map mapRun(const std::string& name, const Run& run,
                         const MappingOptions& options = {});

}  // namespace sbox::dataset
