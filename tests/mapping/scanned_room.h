// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "sbox/core/key_frame.h"
#include "sbox/core/pose.h"

namespace sbox::test {

/// An empty room whose walls are where x or y has these values.
struct Room {
  double x_min = -2.02;
  double x_max = 3.02;
  double y_min = -1.02;
  double y_max = 2.02;
};

/// What an exact lidar that looks all around sees from `sensor_in_room`.
inline mrpt::obs::CObservation2DRangeScan::Ptr scanRoom(const Room& room,
                                                        const Pose2D& sensor_in_room) {
  constexpr int beams = 720;
  auto scan = std::make_shared<mrpt::obs::CObservation2DRangeScan>();
  scan->aperture = static_cast<float>(2 * M_PI);
  scan->maxRange = 30;
  scan->resizeScan(beams);
  const auto along = [](double from, double step, double low, double high) {
    return step > 0   ? (high - from) / step
           : step < 0 ? (low - from) / step
                      : std::numeric_limits<double>::infinity();
  };
  for (int i = 0; i < beams; ++i) {
    const double angle = sensor_in_room.phi - M_PI + 2 * M_PI * i / (beams - 1);
    const double range = std::min(along(sensor_in_room.x, std::cos(angle), room.x_min, room.x_max),
                                  along(sensor_in_room.y, std::sin(angle), room.y_min, room.y_max));
    scan->setScanRange(static_cast<size_t>(i), static_cast<float>(range));
    scan->setScanRangeValidity(static_cast<size_t>(i), true);
  }
  return scan;
}

/// A key frame whose pose in the map is as given, whatever the room's frame.
inline KeyFrame keyFrame(const Room& room, const Pose2D& robot_in_room,
                         const Pose2D& robot_in_map) {
  auto seen = std::make_shared<mrpt::obs::CSensoryFrame>();
  seen->insert(scanRoom(room, robot_in_room));
  return {std::make_shared<mrpt::poses::CPose3DPDFGaussian>(
              mrpt::poses::CPose3D(mrpt::math::TPose3D(robot_in_map))),
          seen};
}

/// Planar mean pose of a key frame.
inline Pose2D poseOf(const KeyFrame& key_frame) {
  return mrpt::math::TPose2D(key_frame.robot_in_map->getMeanVal().asTPose());
}

}  // namespace sbox::test
