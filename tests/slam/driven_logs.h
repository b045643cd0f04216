// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Logs of a robot that drives a curve in a bare room, in both forms that rawlogs take.
#pragma once

#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CRawlog.h>

#include <memory>
#include <vector>

#include "mapping/scanned_room.h"

namespace sbox::test {

/// Poses 0.1 m apart on a curve through a Room, the first at the origin.
inline std::vector<Pose2D> drivenPath() {
  std::vector<Pose2D> path{{0, 0, 0}};
  for (int i = 0; i < 20; ++i) {
    path.push_back(path.back() + Pose2D(0.1, 0, 0.05));
  }
  return path;
}

/// Odometry that turns too far and drives too short.
inline Pose2D badOdometry(const Pose2D& increment) {
  return {0.9 * increment.x, increment.y, 1.1 * increment.phi};
}

inline mrpt::Clock::time_point secondsIn(double seconds) {
  return mrpt::Clock::fromDouble(1.6e9 + seconds);
}

/// Times 0.1 s apart; INVALID_TIMESTAMP if not `timed`.
inline mrpt::Clock::time_point timeOf(size_t step, bool timed) {
  return timed ? secondsIn(0.1 * static_cast<double>(step)) : INVALID_TIMESTAMP;
}

/// A log of actions and sensory frames.
inline mrpt::obs::CRawlog pairedLog(bool timed = true) {
  using namespace mrpt::obs;
  const std::vector<Pose2D> path = drivenPath();
  CRawlog log;
  for (size_t i = 0; i < path.size(); ++i) {
    CActionRobotMovement2D moved;
    const Pose2D increment = i == 0 ? Pose2D() : badOdometry(inverse(path[i - 1]) + path[i]);
    moved.computeFromOdometry(mrpt::poses::CPose2D(increment), {});
    moved.timestamp = timeOf(i, timed);
    CActionCollection actions;
    actions.insert(moved);
    log.insert(actions);
    CSensoryFrame frame;
    const auto scan = scanRoom({}, path[i]);
    scan->timestamp = timeOf(i, timed);
    frame.insert(scan);
    log.insert(frame);
  }
  return log;
}

/// A log of bare observations: odometry at the whole tenths of a second, scans half way between
/// two, of one lidar or of two that look forward and back.
inline mrpt::obs::CRawlog bareLog(int lidars = 1, bool with_odometry = true) {
  using namespace mrpt::obs;
  const std::vector<Pose2D> path = drivenPath();
  CRawlog log;
  Pose2D odometry{5, 5, 1};
  for (size_t i = 0; i < path.size(); ++i) {
    const Pose2D increment = i == 0 ? Pose2D() : inverse(path[i - 1]) + path[i];
    odometry = odometry + badOdometry(increment);
    auto reading = std::make_shared<CObservationOdometry>();
    reading->odometry = mrpt::poses::CPose2D(odometry);
    reading->timestamp = timeOf(i, true);
    if (with_odometry) {
      log.insert(std::static_pointer_cast<mrpt::serialization::CSerializable>(reading));
    }
    if (i + 1 == path.size()) {
      break;
    }
    const Pose2D next = inverse(path[i]) + path[i + 1];
    const Pose2D robot = path[i] + Pose2D(next.x / 2, next.y / 2, next.phi / 2);
    for (int lidar = 0; lidar < lidars; ++lidar) {
      const Pose2D on_robot{lidar == 0 ? 0.1 : -0.1, 0, lidar * M_PI};
      const auto scan = scanRoom({}, robot + on_robot);
      scan->sensorPose = mrpt::poses::CPose3D(mrpt::math::TPose3D(on_robot));
      scan->sensorLabel = lidar == 0 ? "front" : "rear";
      scan->timestamp = secondsIn(0.1 * static_cast<double>(i) + 0.05);
      log.insert(std::static_pointer_cast<mrpt::serialization::CSerializable>(scan));
    }
  }
  return log;
}

}  // namespace sbox::test
