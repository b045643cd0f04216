// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The poses of merged maps as ROS's transforms: frame "map" is the merged map's, "NAME/map" that of
// the map read from NAME.yaml. Merged maps of further groups have "map_group<N>".
#pragma once

#include <string>

#include "sbox/merge_result.h"

namespace sbox {

/// Commands that publish the transform of each merged map, for ROS 2 and, as comments, for ROS 1:
/// a shell script that runs until it is stopped.
[[nodiscard]] std::string tfScript(const MergeResult& result);

/// The same as a tf2_msgs/TFMessage in YAML.
[[nodiscard]] std::string tfYaml(const MergeResult& result);

}  // namespace sbox
