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

mrpt::maps::COccupancyGridMap2D::cellType rosCell(int percent) {
  if (percent == ros_unknown) {
    return 0;
  }
  const float p_free = std::clamp(1 - static_cast<float>(percent) / 100, 0.01F, 0.99F);
  return mrpt::maps::COccupancyGridMap2D::p2l(p_free);
}

std::vector<mrpt::maps::COccupancyGridMap2D::cellType> rosCellTable(const RosShading& shading,
                                                                    int channels) {
  std::vector<mrpt::maps::COccupancyGridMap2D::cellType> table;
  for (int sum = 0; sum <= 255 * channels; ++sum) {
    table.push_back(rosCell(rosOccupancy(static_cast<double>(sum) / channels, shading)));
  }
  return table;
}

}  // namespace sbox
