// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/logged_runs.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace sbox::dataset {

using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CRawlog;

LoggedScans::LoggedScans(const std::string& path) {
  if (!log_.loadFromRawLogFile(path)) {
    throw std::runtime_error(path + ": cannot be read as a rawlog");
  }
  for (size_t i = 1; i < log_.size(); ++i) {
    if (log_.getType(i - 1) != CRawlog::etActionCollection ||
        log_.getType(i) != CRawlog::etSensoryFrame) {
      continue;
    }
    if (!log_.getAsObservations(i)->getObservationByClass<CObservation2DRangeScan>()) {
      throw std::runtime_error(path + ": entry " + std::to_string(i) + " holds no 2D scan");
    }
    entries_.push_back(i);
  }
}

const CObservation2DRangeScan& LoggedScans::scan(size_t index) const {
  return *log_.getAsObservations(entries_.at(index))
              ->getObservationByClass<CObservation2DRangeScan>();
}

void LoggedScans::save(size_t first, size_t count, const std::string& path) const {
  if (first > size() || count > size() - first) {
    throw std::runtime_error("the log has only " + std::to_string(size()) + " scans");
  }
  CRawlog part;
  for (size_t i = first; i < first + count; ++i) {
    part.insert(log_.getAsAction(entries_[i] - 1));
    part.insert(log_.getAsObservations(entries_[i]));
  }
  if (!part.saveToRawLogFile(path)) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

std::vector<Pose2D> loadPoses(const std::string& path) {
  std::ifstream file(path);
  if (!file) {
    throw std::runtime_error(path + ": cannot be read");
  }
  std::vector<Pose2D> poses;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    double index = 0;
    Pose2D pose;
    if (!(words >> index >> pose.x >> pose.y >> pose.phi)) {
      throw std::runtime_error(path + ":" + std::to_string(poses.size() + 1) +
                               ": expected: index x y phi");
    }
    poses.push_back(pose);
  }
  return poses;
}

Run cutRun(const LoggedScans& log, const std::vector<Pose2D>& poses_in_world, size_t first,
           const std::vector<Pose2D>& poses_in_map) {
  if (poses_in_world.size() != log.size() || first > log.size() ||
      poses_in_map.size() > log.size() - first) {
    throw std::invalid_argument("there must be as many scans as poses");
  }
  Run run;
  for (size_t i = 0; i < poses_in_map.size(); ++i) {
    run.push_back({poses_in_world[first + i], poses_in_map[i], log.scan(first + i)});
  }
  return run;
}

}  // namespace sbox::dataset
