// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <sstream>

#include "catch.h"
#include "report/html_result.h"
#include "sbox/report/tf_text.h"

using namespace sbox;
using namespace sbox::test;

namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    all.push_back(line);
  }
  return all;
}

}  // namespace

TEST_CASE("transforms are commands for ROS 2 and, as comments, for ROS 1") {
  const std::vector<std::string> text = lines(tfScript(htmlCase().result));
  REQUIRE(text.size() == 10);
  CHECK(text[0] == "#!/bin/sh");
  CHECK(text[2] == "# maps/first.yaml");
  CHECK(text[3] ==
        "ros2 run tf2_ros static_transform_publisher --x 0.000000 --y 0.000000 --z 0 --yaw "
        "0.000000000 --pitch 0 --roll 0 --frame-id map --child-frame-id first/map &");
  CHECK(text[4] == "# maps/second.yaml");
  CHECK(text[5] ==
        "ros2 run tf2_ros static_transform_publisher --x 6.000000 --y 0.000000 --z 0 --yaw "
        "1.570796327 --pitch 0 --roll 0 --frame-id map --child-frame-id second/map &");
  CHECK(text[8] ==
        "# rosrun tf2_ros static_transform_publisher 6.000000 0.000000 0 1.570796327 0 0 map "
        "second/map &");
  CHECK(text[9] == "wait");
}

TEST_CASE("transforms are a tf2_msgs/TFMessage in YAML") {
  const std::vector<std::string> text = lines(tfYaml(htmlCase().result));
  REQUIRE(text.size() == 14);
  CHECK(text[1] == "transforms:");
  CHECK(text[8] == "# maps/second.yaml");
  CHECK(text[9] == "- header: {frame_id: map}");
  CHECK(text[10] == "  child_frame_id: second/map");
  CHECK(text[11] == "  transform:");
  CHECK(text[12] == "    translation: {x: 6.000000, y: 0.000000, z: 0.0}");
  CHECK(text[13] == "    rotation: {x: 0.0, y: 0.0, z: 0.707106781, w: 0.707106781}");
}

TEST_CASE("merged maps of further groups have frames of their own") {
  HtmlCase made = htmlCase();
  MergedGroup other;
  other.group = 1;
  other.members = {2};
  made.result.merged.push_back(other);
  CHECK(tfYaml(made.result).find("- header: {frame_id: map_group1}\n  child_frame_id: third/map") !=
        std::string::npos);
}
