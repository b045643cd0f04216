// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/ros_reader.h"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace sbox::test {
namespace {

/// "key: value" lines.
std::map<std::string, std::string> readKeys(const std::filesystem::path& path) {
  std::map<std::string, std::string> keys;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const size_t colon = line.find(": ");
    if (colon == std::string::npos) {
      throw std::runtime_error("no key in: " + line);
    }
    keys[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return keys;
}

int trinary(int pixel, bool negate, double occ_th, double free_th, RosReader reader) {
  if (reader == RosReader::Ros1) {
    // double occ = negate ? color / 255.0 : (255 - color) / 255.0;
    const double occ = (negate ? pixel : 255 - pixel) / 255.0;
    return occ > occ_th ? 100 : occ < free_th ? 0 : -1;
  }
  // auto shade = pixel / MaxRGB; double occ = negate ? shade : 1.0 - shade;
  const double shade = pixel / 255.0, occ = negate ? shade : 1.0 - shade;
  return occ_th < occ ? 100 : occ < free_th ? 0 : -1;
}

}  // namespace

OccupancyGrid readAsRos(const std::filesystem::path& yaml, RosReader reader) {
  auto keys = readKeys(yaml);
  if (keys.at("mode") != "trinary") {
    throw std::runtime_error("mode " + keys.at("mode"));
  }
  OccupancyGrid grid;
  grid.resolution = std::stod(keys.at("resolution"));
  char bracket = 0, comma = 0;
  std::istringstream origin(keys.at("origin"));
  origin >> bracket >> grid.x >> comma >> grid.y >> comma >> grid.yaw;
  const bool negate = std::stoi(keys.at("negate")) != 0;
  const double occ_th = std::stod(keys.at("occupied_thresh"));
  const double free_th = std::stod(keys.at("free_thresh"));

  std::ifstream image(yaml.parent_path() / keys.at("image"), std::ios::binary);
  std::string magic;
  int largest = 0;
  image >> magic >> grid.width >> grid.height >> largest;
  image.get();
  std::string pixels(static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height), '\0');
  image.read(pixels.data(), static_cast<std::streamsize>(pixels.size()));
  if (magic != "P5" || largest != 255 || !image) {
    throw std::runtime_error("the image is no PGM of 8 bits");
  }
  // The image's top row is the grid's last.
  for (int y = grid.height - 1; y >= 0; --y) {
    for (int x = 0; x < grid.width; ++x) {
      const char pixel =
          pixels[static_cast<size_t>(y) * static_cast<size_t>(grid.width) + static_cast<size_t>(x)];
      grid.data.push_back(
          trinary(static_cast<unsigned char>(pixel), negate, occ_th, free_th, reader));
    }
  }
  return grid;
}

}  // namespace sbox::test
