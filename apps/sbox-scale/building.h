// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "sbox/core/map.h"

namespace sbox::scale {

inline constexpr double cell_size = 0.05;  ///< Of all maps here, in metres.

/// A made-up building: storeys of rooms of many widths along corridors, every size alike in its
/// details. A square of cells.
class Building {
 public:
  /// Different seeds give different buildings. `side` in cells.
  Building(int side, unsigned seed);

  /// A map of side x side cells that sees the part of the building round the middle of the map, up
  /// to `radius` metres away, where the map's frame has the pose `pose_in_building`. The rest is
  /// unknown.
  [[nodiscard]] Map mapAt(const std::string& name, const Pose2D& pose_in_building, int side,
                          double radius) const;

 private:
  void fill(int x0, int y0, int x1, int y1, std::int8_t value);

  int side_;
  std::vector<std::int8_t> cells_;  ///< As MRPT's, row by row.
};

}  // namespace sbox::scale
