// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/ros_yaml.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "sbox/core/number_text.h"
#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"
#include "sbox/io/flat_yaml.h"
#include "sbox/io/map_checks.h"

namespace sbox {
namespace {

/// A map's .yaml has a few hundred bytes.
constexpr std::uint64_t max_yaml_bytes = 1 << 20;

constexpr std::array<std::pair<const char*, RosMode>, 3> modes = {
    {{"trinary", RosMode::Trinary}, {"scale", RosMode::Scale}, {"raw", RosMode::Raw}}};

/// Looks values up by key; what is missing or of the wrong kind is a FileError that names the key.
class Values {
 public:
  explicit Values(const std::string& path) : path_(path) {
    const Bytes bytes = readFile(path, max_yaml_bytes);
    try {
      values_ = parseFlatYaml({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const std::invalid_argument& error) {
      throw FileError(path, std::string("is no YAML of a map: ") + error.what());
    }
  }

  [[noreturn]] void fail(const std::string& key, const std::string& reason) const {
    throw FileError(path_, "\"" + key + "\" " + reason);
  }
  [[nodiscard]] std::optional<std::string> text(const std::string& key) const {
    const auto value = values_.find(key);
    if (value == values_.end()) {
      return std::nullopt;
    }
    if (value->second.kind != FlatYamlValue::Kind::Scalar || value->second.items.size() != 1) {
      fail(key, "is not a single value");
    }
    return value->second.items[0];
  }
  [[nodiscard]] std::string requiredText(const std::string& key) const {
    const std::optional<std::string> value = text(key);
    if (!value || value->empty()) {
      fail(key, "is missing");
    }
    return *value;
  }
  [[nodiscard]] double number(const std::string& key, const std::string& value) const {
    const std::optional<double> parsed = parseNumber(value);
    if (!parsed) {
      fail(key, "is not a number: " + value);
    }
    return *parsed;
  }
  [[nodiscard]] Pose2D pose(const std::string& key) const {
    const auto value = values_.find(key);
    if (value == values_.end()) {
      fail(key, "is missing");
    }
    const std::vector<std::string>& items = value->second.items;
    if (value->second.kind != FlatYamlValue::Kind::List || items.size() != 3) {
      fail(key, "is not a list of three numbers: x and y in metres, yaw in radians");
    }
    return {number(key, items[0]), number(key, items[1]), number(key, items[2])};
  }

 private:
  std::string path_;
  std::map<std::string, FlatYamlValue> values_;
};

/// ROS takes an integer or one of YAML's words for yes and no.
bool readNegate(const Values& values) {
  const std::string text = values.text("negate").value_or("0");
  for (const char* word : {"true", "True", "TRUE", "yes", "Yes", "YES", "on", "On", "ON"}) {
    if (text == word) {
      return true;
    }
  }
  for (const char* word : {"false", "False", "FALSE", "no", "No", "NO", "off", "Off", "OFF"}) {
    if (text == word) {
      return false;
    }
  }
  return values.number("negate", text) != 0;
}

RosMode readMode(const Values& values) {
  const std::string text = values.text("mode").value_or("trinary");
  for (const auto& [name, mode] : modes) {
    if (text == name) {
      return mode;
    }
  }
  values.fail("mode", "is not trinary, scale or raw but " + text);
}

RosShading readShading(const Values& values) {
  RosShading shading;
  shading.mode = readMode(values);
  shading.negate = readNegate(values);
  const auto threshold = [&](const std::string& key, double& share) {
    if (const std::optional<std::string> text = values.text(key)) {
      share = values.number(key, *text);
      if (share < 0 || share > 1) {
        values.fail(key, "is not between 0 and 1: " + *text);
      }
    }
  };
  threshold("occupied_thresh", shading.occupied_thresh);
  threshold("free_thresh", shading.free_thresh);
  if (shading.free_thresh > shading.occupied_thresh ||
      (shading.free_thresh == shading.occupied_thresh && shading.mode == RosMode::Scale)) {
    values.fail("free_thresh", "is not below \"occupied_thresh\"");
  }
  return shading;
}

}  // namespace

RosYaml loadRosYaml(const std::string& path) {
  const Values values(path);
  RosYaml yaml;
  yaml.image = values.requiredText("image");
  yaml.resolution = values.number("resolution", values.requiredText("resolution"));
  checkResolution(path, yaml.resolution);
  yaml.origin = values.pose("origin");
  constexpr double most_yaw = 6.3;  // A full turn, however it was rounded.
  if (!(std::abs(yaml.origin.phi) <= most_yaw)) {
    values.fail("origin", "has a yaw beyond a full turn; it is in radians");
  }
  checkCorner(path, yaml.origin);
  yaml.shading = readShading(values);
  return yaml;
}

std::string rosImagePath(const std::string& path, const RosYaml& yaml) {
  return (std::filesystem::path(path).parent_path() / yaml.image).string();
}

std::string rosYamlText(const RosYaml& yaml) {
  std::string text = "image: " + yamlScalar(yaml.image) + "\n";
  for (const auto& [name, mode] : modes) {
    if (mode == yaml.shading.mode) {
      text += std::string("mode: ") + name + "\n";
    }
  }
  // The grid holds its cell size as a float: the shortest text for that is what was meant.
  text += "resolution: " + numberText(static_cast<float>(yaml.resolution)) + "\n";
  text += "origin: [" + plainNumberText(yaml.origin.x) + ", " + plainNumberText(yaml.origin.y) +
          ", " + plainNumberText(yaml.origin.phi) + "]\n";
  text += std::string("negate: ") + (yaml.shading.negate ? "1" : "0") + "\n";
  text += "occupied_thresh: " + numberText(yaml.shading.occupied_thresh) + "\n";
  text += "free_thresh: " + numberText(yaml.shading.free_thresh) + "\n";
  return text;
}

}  // namespace sbox
