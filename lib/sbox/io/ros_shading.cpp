// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/ros_shading.h"

#include <algorithm>
#include <cmath>

namespace sbox {

int rosOccupancy(double shade, const RosShading& shading) {
  if (shading.mode == RosMode::Raw) {
    const double percent = std::round(shade);
    return percent <= 100 ? static_cast<int>(percent) : ros_unknown;
  }
  const double occupancy = (shading.negate ? shade : 255 - shade) / 255;
  if (occupancy > shading.occupied_thresh) {
    return 100;
  }
  if (shade == (shading.negate ? 50 : 205)) {
    return ros_unknown;
  }
  if (occupancy < shading.free_thresh) {
    return 0;
  }
  if (shading.mode == RosMode::Trinary) {
    return ros_unknown;
  }
  return static_cast<int>(std::rint((occupancy - shading.free_thresh) /
                                    (shading.occupied_thresh - shading.free_thresh) * 100));
}

CellLogOdds rosCell(int percent) {
  if (percent == ros_unknown) {
    return 0;
  }
  const double p_free = std::clamp(1 - percent / 100.0, 0.01, 0.99);
  using mrpt::maps::COccupancyGridMap2D;
  // MRPT's own p2l reads a table of 256 steps and is off by several cells' values near 0 and 1.
  int nearest = 0;
  for (int value = -127; value <= 127; ++value) {
    if (std::abs(COccupancyGridMap2D::l2p(static_cast<CellLogOdds>(value)) - p_free) <
        std::abs(COccupancyGridMap2D::l2p(static_cast<CellLogOdds>(nearest)) - p_free)) {
      nearest = value;
    }
  }
  return static_cast<CellLogOdds>(nearest);
}

std::vector<CellLogOdds> rosCellTable(const RosShading& shading, int channels) {
  std::vector<CellLogOdds> table;
  for (int sum = 0; sum <= 255 * channels; ++sum) {
    table.push_back(rosCell(rosOccupancy(static_cast<double>(sum) / channels, shading)));
  }
  return table;
}

}  // namespace sbox
