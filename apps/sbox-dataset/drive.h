// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A simulated robot: it turns on the spot towards the next point of its path, drives straight to
// it, and looks round with its lidar at every step. It knows its way by noisy odometry only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sbox-dataset/ranger.h"
#include "sbox-dataset/run.h"
#include "sbox-dataset/world.h"

namespace sbox::dataset {

/// Where a robot starts, which is the origin of its map, and the points it drives to.
struct Path {
  Pose2D start_in_world;
  std::vector<Point2D> points_in_world;
};

/// Reads a path from a text file: one line "start x y heading_deg", then lines "to x y", in metres.
/// Throws std::runtime_error "PATH:LINE: reason".
[[nodiscard]] Path loadPath(const std::string& path);

struct DriveOptions {
  double step_length = 0.1;             ///< Metres driven between two scans.
  double step_angle = 0.14;             ///< Radians turned between two scans.
  int beams = 361;                      ///< Rays of a scan.
  double field_of_view = 4.7123889804;  ///< Angle that a scan spans, in radians.
  double max_range = 8;                 ///< A wall further away than this is not seen, metres.
  double range_sigma = 0.01;            ///< Standard deviation of a range, in metres.
  double odometry_sigma = 0.002;        ///< Standard deviation of a step's length, share of it.
  double heading_sigma = 0.0006;        ///< Standard deviation of a step's angle, in radians.
  std::uint32_t seed = 1;
};

/// Drives a robot along a path, with a lidar that sees what `ranger` says. The same seed gives the
/// same run.
[[nodiscard]] Run drive(const Ranger& ranger, const Path& path, const DriveOptions& options = {});

/// The same with the exact ranges to the world's walls.
[[nodiscard]] Run drive(const World& world, const Path& path, const DriveOptions& options = {});

}  // namespace sbox::dataset
