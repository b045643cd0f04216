// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plane world that simulated robots drive through: wall segments without thickness.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/feature_set.h"

namespace sbox::dataset {

/// All in the world frame, metres.
struct World {
  std::vector<LineSegment> walls;
  std::vector<Point2D> places;          ///< Spots worth a visit, such as the middle of each room.
  std::vector<LineSegment> yardsticks;  ///< Walls of known length, from corner to corner of a room.
};

/// Reads a world from a text file. A line is one of
///   wall x y x y [x y ...]             a polyline
///   slab x y x y thickness             a thick wall by the ends of its middle line
///   box  x y length width angle_deg    a piece of furniture by its centre
///   place x y                          a spot worth a visit
///   yardstick x y x y                  a wall whose length is measured; the room lies to its left
/// in metres; what follows a # is a comment. Throws std::runtime_error "PATH:LINE: reason".
[[nodiscard]] World loadWorld(const std::string& path);

/// Writes a world as such a text file, slabs and boxes as their outlines. Throws std::runtime_error
/// if it cannot be written.
void saveWorld(const World& world, const std::string& path);

/// Adds the outline of a box that lies with its middle at `centre_in_world`, its length along x.
void addBox(World& world, const Pose2D& centre_in_world, double length, double width);

/// Distance from `eye` to the first wall in direction `angle` (radians, world frame), in metres;
/// infinity where no wall stands.
[[nodiscard]] double distanceToWall(const World& world, const Point2D& eye, double angle);

}  // namespace sbox::dataset
