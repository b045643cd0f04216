// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a robot's log to its map, by MRPT's own SLAM.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "sbox/core/key_frame.h"
#include "sbox/core/progress.h"
#include "sbox/slam/scan_log.h"

namespace sbox {

/// A log or settings that SLAM can do nothing with. what() is one line, fit to follow the file's
/// name.
class SlamError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which SLAM of MRPT's maps a log.
enum class SlamMethod {
  Icp,  ///< mrpt::slam::CMetricMapBuilderICP: each scan against a map of points.
  Rbpf  ///< mrpt::slam::CMetricMapBuilderRBPF: particles, each with a map; needs odometry.
};

/// How a log is mapped.
struct SlamOptions {
  SlamMethod method = SlamMethod::Icp;  ///< Which of MRPT's.
  /// Ini text as MRPT's icp-slam or rbpf-slam read it; empty: defaultSlamSettings(method).
  std::string settings;
  unsigned seed = 1;  ///< Of Rbpf's random numbers.
};

/// The settings shipped with this library, with comments; see slam/settings/.
[[nodiscard]] const std::string& defaultSlamSettings(SlamMethod method);

/// Runs SLAM over the log and returns what it put into its map, in the frame that the robot started
/// in. Times of the log are put in order where MRPT needs that (see stamp_steps.h). `step_done` is
/// called after every step; what it throws ends the work. Throws SlamError if the
/// settings cannot be used or SLAM fails on the log.
///
/// Rbpf draws from MRPT's one random generator: run one at a time. Same log, same result.
[[nodiscard]] KeyFrames runSlam(ScanLog log, const SlamOptions& options = {},
                                const std::function<void()>& step_done = {});

}  // namespace sbox
