// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox/core/map.h"
#include "sbox/io/output_files.h"

namespace sbox {

/// Writes a map by the extension of the path: .gridmap or .gridmap.gz (MRPT), .yaml or .yml (ROS,
/// with a .pgm of the same stem beside it), or .png or .pgm (a picture, which holds no pose).
///
/// What is kept: MRPT's files keep the cells bit for bit but resample a map with yaw (see
/// gridmap_file.h); ROS's keep the pose exactly and the state of each cell (see ros_map_file.h).
/// The path is left as it was until all is written. Throws FileError.
void saveMap(const Map& map, const std::string& path);

/// The same among other outputs: nothing is there before files.commit().
void saveMap(const Map& map, const std::string& path, OutputFiles& files);

/// The files that saveMap writes for this path: itself, and the image beside a .yaml.
[[nodiscard]] std::vector<std::string> filesOfMap(const std::string& path);

/// Whether saveMap knows the extension of the path.
[[nodiscard]] bool canSaveMap(const std::string& path);

}  // namespace sbox
