// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a .gridmap, compressed or not: a map or a FileError; and a map that was read is
// written and read back the same.
#include <cmath>

#include "fuzz/input_folder.h"
#include "sbox/io/file_error.h"
#include "sbox/io/gridmap_file.h"

using namespace sbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFolder folder;
  const std::string path = folder.write("in.gridmap", {data, data + size});
  Map map;
  try {
    map = loadGridmap(path);
  } catch (const FileError&) {
    return 0;
  }
  fuzz::require(map.width() > 0 && map.height() > 0 && map.resolution() > 0);
  fuzz::require(std::isfinite(map.corner_in_map.x) && std::isfinite(map.corner_in_map.y));
  const std::string again = folder.path("again.gridmap");
  try {
    saveGridmap(map, again);
  } catch (const FileError&) {
    return 0;  // too far from zero for MRPT's floats
  }
  const Map read = loadGridmap(again);
  fuzz::require(read.grid.getRawMap() == map.grid.getRawMap());
  fuzz::require(read.corner_in_map.x == map.corner_in_map.x &&
                read.corner_in_map.y == map.corner_in_map.y);
  return 0;
}
