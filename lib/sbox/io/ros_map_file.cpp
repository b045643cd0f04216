// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/ros_map_file.h"

#include <algorithm>

#include "sbox/core/state_limits.h"
#include "sbox/io/file_error.h"
#include "sbox/io/map_checks.h"
#include "sbox/io/ros_yaml.h"

namespace sbox {
namespace {

/// Image rows run from the top, the grid's from the bottom.
void fillCells(const Image& image, const RosShading& shading, Map& map) {
  const int colours = std::min(image.channels, 3);
  const std::vector<CellLogOdds> cells = rosCellTable(shading, colours);
  const bool see_through_is_unknown = image.channels == 4 && shading.mode != RosMode::Raw;
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* pixel = image.row(image.height - 1 - y);
    CellLogOdds* row = map.grid.getRow(y);
    for (int x = 0; x < image.width; ++x, pixel += image.channels) {
      const unsigned sum = colours == 1 ? pixel[0] : 0U + pixel[0] + pixel[1] + pixel[2];
      row[x] = see_through_is_unknown && pixel[3] != 255 ? CellLogOdds{0} : cells[sum];
    }
  }
}

}  // namespace

Map loadRosMap(const std::string& path) {
  const RosYaml yaml = loadRosYaml(path);
  const std::string image_path = rosImagePath(path, yaml);
  Image image;
  try {
    image = loadImage(image_path);
  } catch (const FileError& error) {
    throw FileError(image_path, error.reason() + " (it is the image of " + path + ")");
  }
  Map map = makeMap(path, image.width, image.height, yaml.resolution, yaml.origin);
  fillCells(image, yaml.shading, map);
  return map;
}

Map loadImageMap(const std::string& path, double resolution) {
  checkResolution(path, resolution);
  const Image image = loadImage(path);
  Map map = makeMap(path, image.width, image.height, resolution);
  fillCells(image, RosShading(), map);
  return map;
}

Image rosPicture(const Map& map) {
  constexpr std::uint8_t free = 254, occupied = 0, unknown = 205;
  const StateLimits limits = stateLimits(StateOptions());
  Image image{map.width(), map.height(), 1, Bytes(map.grid.getRawMap().size())};
  auto pixel = image.pixels.begin();
  for (int y = map.height() - 1; y >= 0; --y) {
    const CellLogOdds* row = map.grid.getRow(y);
    pixel = std::transform(row, row + map.width(), pixel, [limits](CellLogOdds cell) {
      const CellState state = limits.stateOf(cell);
      return state == CellState::Free ? free : state == CellState::Occupied ? occupied : unknown;
    });
  }
  return image;
}

std::string rosMapText(const Map& map, const std::string& image) {
  return rosYamlText({image, map.resolution(), map.corner_in_map, RosShading()});
}

}  // namespace sbox
