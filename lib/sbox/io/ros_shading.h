// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How ROS turns the shades of an image into occupancy: nav2_map_server's map_io.cpp and ROS 1
// map_server's image_loader.cpp, which agree but where said.
#pragma once

#include <cstdint>
#include <vector>

#include "sbox/core/state_limits.h"

namespace sbox {

/// How the shades of an image are read; `mode` of its .yaml.
enum class RosMode {
  Trinary,  ///< Occupied, free or unknown.
  Scale,    ///< As Trinary, but shades between the thresholds are probabilities; transparent is
            ///< unknown.
  Raw       ///< The pixel's value is the probability in percent; above 100 is unknown.
};

/// The defaults are those of map_saver and of images without a .yaml in ROS 1.
struct RosShading {
  RosMode mode = RosMode::Trinary;  ///< How shades are read.
  bool negate = false;              ///< Black is free. Ignored in raw mode, as in nav2.
  double occupied_thresh = 0.65;    ///< Occupied above this occupancy; black 1, white 0.
  double free_thresh = 0.196;       ///< Free below this occupancy.
};

/// Occupancy of a cell in percent, as in nav_msgs/OccupancyGrid: 0 free to 100 occupied, or
/// `ros_unknown`. `shade` is the mean of a pixel's colour channels, 0 (black) to 255.
///
/// One departure: grey 205, which map_saver writes for unknown, is never taken for free. ROS does
/// so where free_thresh is above 0.196, such as nav2's own default 0.25.
[[nodiscard]] int rosOccupancy(double shade, const RosShading& shading);

/// What rosOccupancy() gives for an unknown cell.
inline constexpr int ros_unknown = -1;

/// MRPT's cell for an occupancy in percent. Free and occupied become probabilities of 0.99 and 0.01
/// of being free: a published map says which, not how surely, and another map may disagree.
[[nodiscard]] CellLogOdds rosCell(int percent);

/// Cells by the sum of `channels` colour values of 0 to 255: `channels` * 255 + 1 of them.
[[nodiscard]] std::vector<CellLogOdds> rosCellTable(const RosShading& shading, int channels);

}  // namespace sbox
