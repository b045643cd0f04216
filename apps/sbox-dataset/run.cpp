// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/run.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/state_grid.h"

namespace sbox::dataset {
namespace {

/// The cells between the first and the last known row and column, and no other.
Map cropToKnown(const Map& map) {
  // Anything but exactly unknown is worth keeping.
  const StateGrid known = classifyCells(map, {0.505, 0.495});
  Map cropped = makeMap(map.name, known.width, known.height, known.resolution, known.corner_in_map);
  const auto x_first = static_cast<int>(
      std::lround((known.corner_in_map.x - map.corner_in_map.x) / known.resolution));
  const auto y_first = static_cast<int>(
      std::lround((known.corner_in_map.y - map.corner_in_map.y) / known.resolution));
  for (int y = 0; y < known.height; ++y) {
    const auto* row = map.grid.getRow(y + y_first) + x_first;
    std::copy(row, row + known.width, cropped.grid.getRow(y));
  }
  return cropped;
}

}  // namespace

Map mapRun(const std::string& name, const Run& run, const MappingOptions& options) {
  Map map;
  map.name = name;
  map.grid.setSize(-1, 1, -1, 1, static_cast<float>(options.resolution), 0.5F);
  map.grid.insertionOptions.maxDistanceInsertion = static_cast<float>(options.max_range);
  map.grid.insertionOptions.maxOccupancyUpdateCertainty = static_cast<float>(options.certainty);
  map.grid.insertionOptions.considerInvalidRangesAsFreeSpace = false;
  map.grid.insertionOptions.wideningBeamsWithDistance = true;
  for (const RunStep& step : run) {
    const mrpt::poses::CPose3D robot_in_map(mrpt::math::TPose3D(step.pose_in_map));
    map.grid.insertObservation(step.scan, robot_in_map);
  }
  map.corner_in_map = {map.grid.getXMin(), map.grid.getYMin(), 0};
  return cropToKnown(map);
}

}  // namespace sbox::dataset
