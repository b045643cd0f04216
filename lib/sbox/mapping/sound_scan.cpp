// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/mapping/sound_scan.h"

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationRange.h>

#include <algorithm>
#include <cmath>

#include "sbox/mapping/sound_pose.h"

namespace sbox {
namespace {

bool isFinite(const mrpt::math::TPose3D& pose) {
  const double sum = pose.x + pose.y + pose.z + pose.yaw + pose.pitch + pose.roll;
  return std::isfinite(sum);
}

bool canBeAperture(double radians) {
  constexpr double all_round = 2 * M_PI, rounding = 0.01;
  return radians >= 0 && radians <= all_round + rounding;
}

bool isSoundScan(const mrpt::obs::CObservation2DRangeScan& scan) {
  for (size_t i = 0; i < scan.getScanSize(); ++i) {
    if (scan.getScanRangeValidity(i) && scan.getScanRange(i) < 0) {
      return false;
    }
  }
  return isSound(scan.sensorPose) && canBeAperture(scan.aperture);
}

/// MRPT spelt the member with two "p" and mended that later.
template <typename Reading>
auto coneOf(const Reading& reading, int /*preferred*/) -> decltype(reading.sensorConeAperture) {
  return reading.sensorConeAperture;
}
template <typename Reading>
auto coneOf(const Reading& reading, long /*else*/) -> decltype(reading.sensorConeApperture) {
  return reading.sensorConeApperture;
}

bool isSoundReading(const mrpt::obs::CObservationRange& reading) {
  return canBeAperture(coneOf(reading, 0)) &&
         std::all_of(reading.sensedData.begin(), reading.sensedData.end(), [](const auto& echo) {
           return isFinite(echo.sensorPose) && !(echo.sensedDistance < 0);
         });
}

}  // namespace

bool isSound(const mrpt::obs::CObservation& observation) {
  if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&observation)) {
    return isSoundScan(*scan);
  }
  if (const auto* reading = dynamic_cast<const mrpt::obs::CObservationRange*>(&observation)) {
    return isSoundReading(*reading);
  }
  return true;
}

}  // namespace sbox
