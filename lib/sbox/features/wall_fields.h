// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Likelihood fields of a map: how far from any place the nearest wall is that faces a given way,
// and how deep in free space the place lies. One lookup a point tells whether a wall of another map
// could stand there. Directed, as the two faces of one wall are seen from different rooms.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "sbox/core/state_grid.h"
#include "sbox/features/wall_lines.h"

namespace sbox {

/// Cells and reach of the fields.
struct FieldOptions {
  double resolution = 0.2;  ///< Of the fields' cells, metres; coarser where a map is so large ...
  double most_cells = 2e6;  ///< ... that it would take more cells.
  double reach = 2.0;       ///< Walls further off are as good as none, metres.
  double sector_overlap = 12;  ///< Normals this far beyond a sector still belong to it, degrees.
};

/// Facing directions are told apart in eight sectors of 45 degrees; sector 0 is round +x.
constexpr int kSectors = 8;

/// Directions in units of a 256th of a turn, so that sums wrap round by themselves.
using ByteAngle = std::uint8_t;
/// The nearest of the 256 directions.
[[nodiscard]] ByteAngle toByteAngle(double radians);
/// The sector that holds a direction.
[[nodiscard]] inline size_t sectorOf(ByteAngle direction) {
  return static_cast<std::uint8_t>(direction + 16) >> 5;
}

/// How far each place is from walls, by the direction these face, and from what is not free.
struct WallFields {
  static constexpr double unit = 0.01;         ///< Of `distances`, metres.
  static constexpr double depth_unit = 0.015;  ///< Of `free_depth`, metres.
  static constexpr std::uint8_t far = 255;     ///< No wall within reach.
  /// No wall point within reach.
  static constexpr std::uint16_t none = std::numeric_limits<std::uint16_t>::max();
  /// Of more wall points the fields know the first.
  static constexpr size_t most_points = none;

  int width = 0;           ///< Cells in a row.
  int height = 0;          ///< Rows.
  double resolution = 0;   ///< Edge length of a cell, metres.
  Eigen::Vector2d origin;  ///< Corner of cell (0, 0) in the grid frame: the fields have a margin.
  /// By sector, then cell: distance from the cell's centre to the nearest wall point that faces the
  /// sector. A map's walls face few ways, so that what is asked for often lies close together.
  std::array<std::vector<std::uint8_t>, kSectors> distances;
  /// The index of that wall point, or `none`.
  std::array<std::vector<std::uint16_t>, kSectors> nearest;
  /// Distance to the nearest cell that is not free; 0 where the cell itself is not. The greatest
  /// value stands for all that is deeper.
  std::vector<std::uint8_t> free_depth;

  /// Index of the cell that holds a point of the grid frame, or -1 outside.
  [[nodiscard]] std::ptrdiff_t cellAt(double x, double y) const {
    const double column = (x - origin.x()) / resolution, row = (y - origin.y()) / resolution;
    if (!(column >= 0 && row >= 0 && column < width && row < height)) {
      return -1;
    }
    return static_cast<std::ptrdiff_t>(row) * width + static_cast<std::ptrdiff_t>(column);
  }
  /// What `free_depth` holds at a point of the grid frame, in `depth_unit`; 0 outside.
  [[nodiscard]] std::uint8_t depthAt(const Eigen::Vector2d& point) const {
    const std::ptrdiff_t cell = cellAt(point.x(), point.y());
    return cell < 0 ? std::uint8_t{0} : free_depth[static_cast<size_t>(cell)];
  }
};

/// The fields of a map's cells and wall points, both in the grid frame; empty where the grid is.
[[nodiscard]] WallFields makeFields(const StateGrid& grid, const std::vector<WallPoint>& points,
                                    const FieldOptions& options = {});

}  // namespace sbox
