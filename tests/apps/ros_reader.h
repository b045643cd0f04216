// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A map's .yaml as ROS itself reads it, written down a second time from its own sources: nothing of
// the library is used.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sbox::test {

/// nav_msgs/OccupancyGrid as far as it matters.
struct OccupancyGrid {
  int width = 0;
  int height = 0;
  double resolution = 0;
  double x = 0, y = 0, yaw = 0;
  std::vector<int> data;  ///< 0 free to 100 occupied, -1 unknown; lowest row first.
};

enum class RosReader {
  Ros1,  ///< map_server's image_loader.cpp
  Nav2   ///< nav2_map_server's map_io.cpp
};

/// Reads a trinary map with a binary PGM of 8 bits. Throws std::runtime_error.
OccupancyGrid readAsRos(const std::filesystem::path& yaml, RosReader reader);

}  // namespace sbox::test
