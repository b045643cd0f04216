// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sbox/core/pose.h"
#include "sbox/io/ros_shading.h"

namespace sbox {

/// The .yaml file of a ROS map.
struct RosYaml {
  std::string image;      ///< Path of the image: absolute, or from the folder of the .yaml.
  double resolution = 0;  ///< Edge length of a cell, in metres.
  Pose2D origin;          ///< Lower-left corner of the image in the map frame, with yaw.
  RosShading shading;     ///< What the shades of the image mean.
};

/// Reads the file. `image`, `resolution` and `origin` must be there; `negate`, `mode` and the
/// thresholds have ROS's defaults; other keys are skipped. Throws FileError.
[[nodiscard]] RosYaml loadRosYaml(const std::string& path);

/// The path of the image that the .yaml at `path` names.
[[nodiscard]] std::string rosImagePath(const std::string& path, const RosYaml& yaml);

/// The text of such a file, numbers exact.
[[nodiscard]] std::string rosYamlText(const RosYaml& yaml);

}  // namespace sbox
