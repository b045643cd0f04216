// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rough shape of what a map knows: enough to tell how far apart two poses of it are, and how
// much two maps would overlap.
#pragma once

#include <cstdint>
#include <vector>

#include "sbox/core/map.h"
#include "sbox/core/pose.h"
#include "sbox/core/state_grid.h"

namespace sbox {

/// A map's known area in coarse cells. The default is a point at the origin, of no area.
struct Footprint {
  Point2D centre;              ///< Middle of the known area, in the map frame.
  double radius = 0;           ///< Root mean square distance of the known area from it, metres.
  std::vector<Point2D> known;  ///< Centres of the coarse cells that are known, in the map frame.
  double cell = 1;             ///< Edge length of a coarse cell, metres.
  Pose2D corner_in_map;        ///< Lower-left corner of coarse cell (0, 0) in the map frame.
  int width = 0;               ///< Coarse cells in a row.
  int height = 0;              ///< Coarse cells in a column.
  std::vector<std::uint8_t> cells;  ///< 1 where known; row by row, lowest row first.
};

/// The footprint of a map, in at most 48 x 48 cells; `states` tells what is known.
[[nodiscard]] Footprint footprintOf(const Map& map, const StateOptions& states = {});

/// The footprints of all maps, on up to `threads` threads (0: one a core).
[[nodiscard]] std::vector<Footprint> footprintsOf(const std::vector<Map>& maps,
                                                  const StateOptions& states, int threads);

/// Known points of map b that map a knows too, in the frame of a.
[[nodiscard]] std::vector<Point2D> commonPoints(const Footprint& a, const Footprint& b,
                                                const Pose2D& pose_b_in_a);

/// Area known to both maps, as a share of what the smaller one knows; in [0, 1], 0 if one knows
/// nothing.
[[nodiscard]] double overlapShare(const Footprint& a, const Footprint& b,
                                  const Pose2D& pose_b_in_a);

/// How far two poses of map b in map a are apart.
struct PoseGap {
  double distance = 0;  ///< Mean of how far they put the middles of the two maps apart, metres.
  double turn = 0;      ///< Between their headings, radians, >= 0.
};

/// The gap between two poses of map b in map a.
[[nodiscard]] PoseGap gapBetween(const Footprint& a, const Footprint& b, const Pose2D& pose_b_in_a,
                                 const Pose2D& other_b_in_a);

}  // namespace sbox
