// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs of real robots: parts of one log, each with the poses that a SLAM gave it on its own; the
// truth is where a SLAM over the whole log puts the same scans.
#pragma once

#include <mrpt/obs/CRawlog.h>

#include <string>
#include <vector>

#include "sbox-dataset/run.h"

namespace sbox::dataset {

/// A log as pairs of what the robot did and the scan it then took: those that MRPT's SLAM apps
/// read.
class LoggedScans {
 public:
  /// Throws std::runtime_error if the file cannot be read as a rawlog or a frame holds no 2D scan.
  explicit LoggedScans(const std::string& path);

  [[nodiscard]] size_t size() const { return entries_.size(); }
  [[nodiscard]] const mrpt::obs::CObservation2DRangeScan& scan(size_t index) const;
  /// Writes `count` pairs from `first` as a rawlog. Throws std::runtime_error if there are not so
  /// many or the file cannot be written.
  void save(size_t first, size_t count, const std::string& path) const;

 private:
  mrpt::obs::CRawlog log_;
  std::vector<size_t> entries_;  ///< Index in the log of each scan's frame.
};

/// The poses in a text file of icp-slam's form: a line "index x y phi" a scan, in metres and
/// radians. Throws std::runtime_error "PATH:LINE: reason".
[[nodiscard]] std::vector<Pose2D> loadPoses(const std::string& path);

/// The run over scans first, first + 1, ... for which `poses_in_map` has poses. Throws
/// std::invalid_argument if there are fewer scans or fewer `poses_in_world`, a pose a scan.
[[nodiscard]] Run cutRun(const LoggedScans& log, const std::vector<Pose2D>& poses_in_world,
                         size_t first, const std::vector<Pose2D>& poses_in_map);

}  // namespace sbox::dataset
