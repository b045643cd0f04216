// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CSensoryFrame.h>

#include <Eigen/Core>
#include <vector>

namespace sbox {

/// A place on a surface that a scan saw.
struct ScanPoint {
  Eigen::Vector2d place;   ///< In the robot's frame, metres.
  Eigen::Vector2d normal;  ///< Of the surface, towards the sensor; of length one.
};

/// How scans become points.
struct ScanPointOptions {
  double max_range = 15;     ///< Farther points are left out, in metres.
  double max_tilt = 0.035;   ///< A lidar tilted more out of the plane is left out, in radians.
  double spacing = 0.1;      ///< Between points kept, in metres: near walls count as far ones do.
  double neighbours = 0.3;   ///< Points of a scan this near make a surface, in metres ...
  double thickness = 0.025;  ///< ... if they deviate no more from a line, in metres.
};

/// Points on the smooth surfaces that the level 2D scans of a frame saw.
[[nodiscard]] std::vector<ScanPoint> scanPoints(const mrpt::obs::CSensoryFrame& seen,
                                                const ScanPointOptions& options = {});

}  // namespace sbox
