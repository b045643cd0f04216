// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/bare_observations.h"

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sbox/core/pose.h"
#include "sbox/slam/planar_movement.h"

namespace sbox {
namespace {

using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CRawlog;

/// Where the wheels say the robot is.
struct Reading {
  size_t entry = 0;  ///< Its place in the log.
  mrpt::Clock::time_point time;
  Pose2D pose;
};

std::vector<Reading> odometryOf(const CRawlog& log) {
  std::vector<Reading> readings;
  for (size_t i = 0; i < log.size(); ++i) {
    if (log.getType(i) != CRawlog::etObservation) {
      continue;
    }
    const auto observation = log.getAsObservation(i);
    if (const auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(observation)) {
      readings.push_back({i, odometry->timestamp, odometry->odometry.asTPose()});
    }
  }
  return readings;
}

bool timed(mrpt::Clock::time_point time) { return time != INVALID_TIMESTAMP; }

/// The pose at the entry's place in the log and its time: between the readings before and after
/// where their times allow, else that before.
Pose2D poseAt(const std::vector<Reading>& readings, size_t entry, mrpt::Clock::time_point time) {
  const auto after = std::find_if(readings.begin(), readings.end(), [&](const Reading& reading) {
    return timed(time) && timed(reading.time) ? reading.time > time : reading.entry > entry;
  });
  if (after == readings.begin()) {
    return after->pose;
  }
  const Reading& before = *(after - 1);
  if (after == readings.end() || !timed(time) || !timed(before.time) || !timed(after->time)) {
    return before.pose;
  }
  const double gap = std::chrono::duration<double>(after->time - before.time).count();
  const double past = std::chrono::duration<double>(time - before.time).count();
  if (!(gap > 0 && past >= 0)) {
    return before.pose;
  }
  const double share = past / gap;
  return {before.pose.x + share * (after->pose.x - before.pose.x),
          before.pose.y + share * (after->pose.y - before.pose.y),
          wrapAngle(before.pose.phi + share * wrapAngle(after->pose.phi - before.pose.phi))};
}

/// Whether the scan is another lidar's view of the very moment of the step.
bool sameMoment(const LogStep& step, const CObservation2DRangeScan& scan) {
  bool same = timed(scan.timestamp);
  for (const auto& seen : *step.seen) {
    same = same && seen->timestamp == scan.timestamp && seen->sensorLabel != scan.sensorLabel;
  }
  return same;
}

}  // namespace

ScanLog stepsOfObservations(const CRawlog& log) {
  const std::vector<Reading> readings = odometryOf(log);
  ScanLog steps;
  steps.has_odometry = !readings.empty();
  Pose2D last;
  for (size_t i = 0; i < log.size(); ++i) {
    if (log.getType(i) != CRawlog::etObservation) {
      continue;
    }
    const auto observation = log.getAsObservation(i);
    const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation);
    if (!scan) {
      continue;
    }
    if (!steps.steps.empty() && sameMoment(steps.steps.back(), *scan)) {
      steps.steps.back().seen->insert(observation);
      continue;
    }
    auto moved = std::make_shared<mrpt::obs::CActionCollection>();
    if (steps.has_odometry) {
      const Pose2D pose = poseAt(readings, i, scan->timestamp);
      const Pose2D increment = steps.steps.empty() ? Pose2D() : inverse(last) + pose;
      moved = planarMovement(mrpt::poses::CPose2D(increment), {}, scan->timestamp);
      last = pose;
    }
    auto seen = std::make_shared<mrpt::obs::CSensoryFrame>();
    seen->insert(observation);
    steps.steps.push_back({moved, seen});
  }
  return steps;
}

}  // namespace sbox
