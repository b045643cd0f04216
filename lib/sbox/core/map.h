// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

#include "sbox/core/pose.h"

namespace sbox {

/// One robot's occupancy grid and where it lies in its own map frame.
///
/// MRPT snaps a grid's extents to multiples of the cell size and knows no rotation, so the place of
/// the cells is kept beside it: `corner_in_map` is what counts everywhere in this library, and the
/// grid's own x_min and y_min only matter when a `.gridmap` file is read or written.
struct Map {
  std::string name;                      ///< What reports call it; the file's path as given.
  mrpt::maps::COccupancyGridMap2D grid;  ///< Cells as MRPT's log-odds of being free; row 0 lowest.
  Pose2D corner_in_map;  ///< Lower-left corner of cell (0, 0) in the map frame; phi turns the rows.

  /// Edge length of a cell, in metres.
  [[nodiscard]] double resolution() const { return grid.getResolution(); }
  /// Cells in a row.
  [[nodiscard]] int width() const { return static_cast<int>(grid.getSizeX()); }
  /// Cells in a column.
  [[nodiscard]] int height() const { return static_cast<int>(grid.getSizeY()); }
  /// Centre of cell (cx, cy) in the map frame.
  [[nodiscard]] Point2D cellCentre(int cx, int cy) const;
};

/// A map of width x height unknown cells of `resolution` metres with its lower-left corner at
/// `corner_in_map`. Throws std::invalid_argument if a size is below 1 or the resolution is not
/// positive and finite.
[[nodiscard]] Map makeMap(std::string name, int width, int height, double resolution,
                          const Pose2D& corner_in_map = {});

}  // namespace sbox
