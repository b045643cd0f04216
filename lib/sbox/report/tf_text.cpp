// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/tf_text.h"

#include <cmath>
#include <vector>

#include "sbox/core/number_text.h"
#include "sbox/core/one_line.h"
#include "sbox/report/short_names.h"

namespace sbox {
namespace {

struct RosTransform {
  std::string file;  ///< Of the map.
  std::string parent;
  std::string child;
  Pose2D pose_child_in_parent;
};

std::vector<RosTransform> transforms(const MergeResult& result) {
  const std::vector<std::string> names = shortNames(result);
  std::vector<RosTransform> all;
  for (const MergedGroup& merged : result.merged) {
    const bool main_group = &merged == &result.merged.front();
    const std::string parent = main_group ? "map" : "map_group" + std::to_string(merged.group);
    for (const int member : merged.members) {
      const auto index = static_cast<size_t>(member);
      all.push_back({result.maps[index].name, parent, names[index] + "/map",
                     result.maps[index].placement.pose});
    }
  }
  return all;
}

std::string fileComment(const RosTransform& transform) {
  return "# " + oneLine(transform.file) + "\n";
}

std::string metres(double value) { return fixedDigits(value, 6); }
std::string unit(double value) { return fixedDigits(value, 9); }

}  // namespace

std::string tfScript(const MergeResult& result) {
  std::string ros2, ros1;
  for (const RosTransform& transform : transforms(result)) {
    const Pose2D& pose = transform.pose_child_in_parent;
    ros2 += fileComment(transform) + "ros2 run tf2_ros static_transform_publisher --x " +
            metres(pose.x) + " --y " + metres(pose.y) + " --z 0 --yaw " + unit(pose.phi) +
            " --pitch 0 --roll 0 --frame-id " + transform.parent + " --child-frame-id " +
            transform.child + " &\n";
    ros1 += "# rosrun tf2_ros static_transform_publisher " + metres(pose.x) + " " + metres(pose.y) +
            " 0 " + unit(pose.phi) + " 0 0 " + transform.parent + " " + transform.child + " &\n";
  }
  return "#!/bin/sh\n# Where each map lies in the merged map. ROS 2:\n" + ros2 +
         "# ROS 1 (x y z yaw pitch roll parent child):\n" + ros1 + "wait\n";
}

std::string tfYaml(const MergeResult& result) {
  std::string text =
      "# Where each map lies in the merged map: a tf2_msgs/TFMessage for /tf_static.\n"
      "transforms:\n";
  for (const RosTransform& transform : transforms(result)) {
    const Pose2D& pose = transform.pose_child_in_parent;
    text += fileComment(transform) + "- header: {frame_id: " + transform.parent +
            "}\n  child_frame_id: " + transform.child +
            "\n  transform:\n    translation: {x: " + metres(pose.x) + ", y: " + metres(pose.y) +
            ", z: 0.0}\n    rotation: {x: 0.0, y: 0.0, z: " + unit(std::sin(pose.phi / 2)) +
            ", w: " + unit(std::cos(pose.phi / 2)) + "}\n";
  }
  return text;
}

}  // namespace sbox
