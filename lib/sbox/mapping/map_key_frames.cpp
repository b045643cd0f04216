// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/mapping/map_key_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sbox/core/map_limits.h"
#include "sbox/mapping/crop_to_known.h"
#include "sbox/mapping/sound_pose.h"
#include "sbox/mapping/sound_scan.h"

namespace sbox {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

/// A box that grows around points.
struct SeenExtent {
  double x_min = std::numeric_limits<double>::infinity();
  double x_max = -std::numeric_limits<double>::infinity();
  double y_min = std::numeric_limits<double>::infinity();
  double y_max = -std::numeric_limits<double>::infinity();

  void add(double x, double y, double margin) {
    x_min = std::min(x_min, x - margin);
    x_max = std::max(x_max, x + margin);
    y_min = std::min(y_min, y - margin);
    y_max = std::max(y_max, y + margin);
  }
};

/// What the beams can reach. Throws if an observation cannot be.
SeenExtent reach(const KeyFrames& key_frames, double max_range) {
  SeenExtent extent;
  for (const KeyFrame& key_frame : key_frames) {
    const mrpt::poses::CPose3D robot = key_frame.robot_in_map->getMeanVal();
    if (!isSound(robot)) {
      throw std::invalid_argument("the pose of a key frame makes no sense");
    }
    for (const auto& observation : *key_frame.seen) {
      if (!isSound(*observation)) {
        throw std::invalid_argument("the pose, angles or ranges of a scan make no sense");
      }
      mrpt::poses::CPose3D sensor_on_robot;
      observation->getSensorPose(sensor_on_robot);
      const mrpt::poses::CPose3D sensor = robot + sensor_on_robot;
      extent.add(sensor.x(), sensor.y(), max_range);
    }
  }
  return extent;
}

/// Checks the size that the map can grow to before memory is taken for it.
void checkExtent(const SeenExtent& extent, double resolution) {
  const double width = std::ceil((extent.x_max - extent.x_min) / resolution);
  const double height = std::ceil((extent.y_max - extent.y_min) / resolution);
  // Floats, in which MRPT keeps the extents, must hold a coordinate to a part of a cell.
  const double farthest = std::max({std::abs(extent.x_min), std::abs(extent.x_max),
                                    std::abs(extent.y_min), std::abs(extent.y_max)});
  if (!(width * height <= static_cast<double>(max_map_cells)) ||
      !(farthest / resolution <= static_cast<double>(max_map_side))) {
    throw std::length_error("the poses lie too far apart for a map in cells of this size");
  }
}

/// A small grid around the robot's first pose, on whole metres; MRPT lets it grow.
void start(Grid& grid, const mrpt::poses::CPose3D& robot, double resolution) {
  const auto x = static_cast<float>(std::round(robot.x()));
  const auto y = static_cast<float>(std::round(robot.y()));
  grid.setSize(x - 1, x + 1, y - 1, y + 1, static_cast<float>(resolution), 0.5F);
}

void check(const MappingOptions& options) {
  if (!(options.resolution >= min_resolution && options.resolution <= max_resolution) ||
      !(options.max_range > 0) || !(options.certainty > 0.5 && options.certainty < 1) ||
      !(options.max_tilt >= 0)) {
    throw std::invalid_argument("mapping options out of range");
  }
}

}  // namespace

Map mapKeyFrames(const std::string& name, const KeyFrames& key_frames,
                 const MappingOptions& options) {
  check(options);
  const SeenExtent extent = reach(key_frames, options.max_range);
  if (!(extent.x_max >= extent.x_min)) {
    throw std::invalid_argument("there are no observations");
  }
  checkExtent(extent, options.resolution);
  Map map;
  map.name = name;
  auto& rules = map.grid.insertionOptions;
  rules.maxDistanceInsertion = static_cast<float>(options.max_range);
  rules.maxOccupancyUpdateCertainty = static_cast<float>(options.certainty);
  rules.horizontalTolerance = static_cast<float>(options.max_tilt);
  rules.considerInvalidRangesAsFreeSpace = false;
  rules.wideningBeamsWithDistance = true;
  start(map.grid, key_frames.front().robot_in_map->getMeanVal(), options.resolution);
  bool any = false;
  for (const KeyFrame& key_frame : key_frames) {
    const mrpt::poses::CPose3D robot = key_frame.robot_in_map->getMeanVal();
    for (const auto& observation : *key_frame.seen) {
      any = map.grid.insertObservation(*observation, robot) || any;
    }
  }
  if (!any) {
    throw std::invalid_argument("no observation is a level 2D scan");
  }
  map.corner_in_map = {map.grid.getXMin(), map.grid.getYMin(), 0};
  return cropToKnown(map);
}

}  // namespace sbox
