// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/adjustment/scan_agreement.h"

#include <cmath>

#include "sbox/core/state_grid.h"

namespace sbox {

double scanAgreement(const KeyFrames& key_frames, const Map& map, const ScanPointOptions& options) {
  const StateGrid states = classifyCells(map);
  double seen = 0, occupied = 0;
  for (const KeyFrame& key_frame : key_frames) {
    const Pose2D robot_in_map(key_frame.robot_in_map->getMeanVal().asTPose());
    for (const ScanPoint& point : scanPoints(*key_frame.seen, options)) {
      const Point2D in_map = robot_in_map.composePoint(Point2D(point.place.x(), point.place.y()));
      const Point2D in_grid = states.corner_in_map.inverseComposePoint(in_map);
      const auto x = static_cast<int>(std::floor(in_grid.x / states.resolution));
      const auto y = static_cast<int>(std::floor(in_grid.y / states.resolution));
      ++seen;
      occupied += states.at(x, y) == CellState::Occupied ? 1 : 0;
    }
  }
  return seen > 0 ? occupied / seen : 0;
}

}  // namespace sbox
