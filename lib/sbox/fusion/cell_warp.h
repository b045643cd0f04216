// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "sbox/core/pose.h"
#include "sbox/fusion/cell_box.h"

namespace sbox {

/// A place in a map's cells, in 2^-32 cells from the centre of its cell (0, 0).
struct SubCell {
  std::int64_t u = 0;  ///< Along a row.
  std::int64_t v = 0;  ///< Along a column.
};

/// One cell as a length in SubCell.
constexpr std::int64_t kSubCellUnit = std::int64_t{1} << 32;

/// Cells along a row, end excluded.
struct CellSpan {
  int first = 0;  ///< First cell.
  int end = 0;    ///< One beyond the last.
};

/// Where the centres of lattice cells lie in a map's cells. In fixed point, so that stepping along
/// a row gives the same place as jumping there, whichever way the work is cut into tiles.
class CellWarp {
 public:
  /// From the pose of the map's grid in the lattice and the two cell sizes in metres. Lattice cells
  /// and map cells must stay within 2^30 of the origins.
  CellWarp(const Pose2D& grid_in_lattice, double map_resolution, double lattice_resolution);

  /// Centre of lattice cell (x, y).
  [[nodiscard]] SubCell at(int x, int y) const {
    return {origin_.u + x * step_x_.u + y * step_y_.u, origin_.v + x * step_x_.v + y * step_y_.v};
  }
  /// What a step to the next cell of a row adds.
  [[nodiscard]] const SubCell& stepX() const { return step_x_; }

  /// The part of `row` within lattice row y whose centres have both low <= (u, v) < high.
  [[nodiscard]] CellSpan spanWithin(const CellSpan& row, int y, const SubCell& low,
                                    const SubCell& high) const;

 private:
  SubCell origin_;
  SubCell step_x_;
  SubCell step_y_;
};

}  // namespace sbox
