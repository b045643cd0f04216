// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a map's .yaml, with images of that name beside it: a map or a FileError; and what
// was read is written and read back the same.
#include <cmath>

#include "fuzz/input_folder.h"
#include "sbox/io/file_error.h"
#include "sbox/io/ros_map_file.h"
#include "sbox/io/ros_yaml.h"

using namespace sbox;

namespace {

Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFolder folder;
  static const std::string image =
      folder.write("a.pgm", bytesOf(std::string("P5\n3 2\n255\n") + "\x01\xFF\xCD\xFE\x80\x20"));
  const std::string path = folder.write("in.yaml", {data, data + size});
  RosYaml yaml;
  try {
    yaml = loadRosYaml(path);
  } catch (const FileError&) {
    return 0;
  }
  const std::string again = folder.write("again.yaml", bytesOf(rosYamlText(yaml)));
  const RosYaml read = loadRosYaml(again);
  fuzz::require(read.image == yaml.image && read.shading.mode == yaml.shading.mode);
  fuzz::require(read.origin.x == yaml.origin.x && read.origin.y == yaml.origin.y &&
                read.origin.phi == yaml.origin.phi);
  fuzz::require(std::abs(read.resolution - yaml.resolution) <= 1e-6 * yaml.resolution);
  try {
    const Map map = loadRosMap(path);
    fuzz::require(map.width() > 0 && map.height() > 0);
  } catch (const FileError&) {
  }
  return 0;
}
