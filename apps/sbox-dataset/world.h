// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plane world that simulated robots drive through: wall segments without thickness.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/feature_set.h"

namespace sbox::dataset {

struct World {
  std::vector<LineSegment> walls;  ///< In the world frame, metres.
};

/// Reads a world from a text file. A line is one of
///   wall x y x y [x y ...]             a polyline
///   box  x y length width angle_deg    a piece of furniture by its centre
/// in metres; what follows a # is a comment. Throws std::runtime_error "PATH:LINE: reason".
[[nodiscard]] World loadWorld(const std::string& path);

/// Distance from `eye` to the first wall in direction `angle` (radians, world frame), in metres;
/// infinity where no wall stands.
[[nodiscard]] double distanceToWall(const World& world, const Point2D& eye, double angle);

}  // namespace sbox::dataset
