// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps as ROS keeps them: an image and a .yaml that says where it lies and what its shades mean;
// or the image alone.
#pragma once

#include <string>

#include "sbox/core/map.h"
#include "sbox/io/image_file.h"

namespace sbox {

/// Reads a .yaml and the image it names. corner_in_map is the origin exactly, yaw included. Colours
/// count by their mean; pixels that are not fully opaque are unknown unless the mode is raw. Throws
/// FileError.
[[nodiscard]] Map loadRosMap(const std::string& path);

/// Reads an image of cells of `resolution` metres, its lower-left corner at (0, 0), with ROS's
/// default thresholds. Throws FileError.
[[nodiscard]] Map loadImageMap(const std::string& path, double resolution);

/// A map as a picture in ROS's greys: 0 occupied, 254 free, 205 unknown, by the thresholds of
/// StateOptions. Read back, each cell has the same state; how sure it was is lost.
[[nodiscard]] Image rosPicture(const Map& map);

/// The .yaml for a map whose rosPicture lies in the file `image`.
[[nodiscard]] std::string rosMapText(const Map& map, const std::string& image);

}  // namespace sbox
