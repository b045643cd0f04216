// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/ranger.h"

#include <mrpt/poses/CPose2D.h>

namespace sbox::dataset {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::obs::CObservation2DRangeScan;

Ranger exactRanger(const World& world) {
  return [&world](const Pose2D& pose_in_world, CObservation2DRangeScan& scan) {
    const size_t beams = scan.getScanSize();
    for (size_t i = 0; i < beams; ++i) {
      const double angle = static_cast<double>(scan.getScanAngle(i));
      const double range =
          distanceToWall(world, {pose_in_world.x, pose_in_world.y}, pose_in_world.phi + angle);
      const bool seen = range < static_cast<double>(scan.maxRange);
      scan.setScanRange(i, seen ? static_cast<float>(range) : scan.maxRange);
      scan.setScanRangeValidity(i, seen);
    }
  };
}

Ranger gridRanger(const COccupancyGridMap2D& grid) {
  return [&grid](const Pose2D& pose_in_world, CObservation2DRangeScan& scan) {
    constexpr float kFreeAbove = 0.5F;
    grid.laserScanSimulator(scan, mrpt::poses::CPose2D(pose_in_world), kFreeAbove,
                            scan.getScanSize());
  };
}

}  // namespace sbox::dataset
