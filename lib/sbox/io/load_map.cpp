// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/load_map.h"

#include <new>
#include <stdexcept>

#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"
#include "sbox/io/gridmap_file.h"
#include "sbox/io/path_extension.h"
#include "sbox/io/ros_map_file.h"
#include "sbox/io/ros_yaml.h"
#include "sbox/io/simplemap_file.h"
#include "sbox/mapping/map_key_frames.h"

namespace sbox {
namespace {

Map loadSimplemap(const std::string& path) {
  try {
    return mapKeyFrames(path, loadKeyFrames(path));
  } catch (const std::invalid_argument& error) {
    throw FileError(path, std::string("cannot be made a grid: ") + error.what());
  } catch (const std::length_error& error) {
    throw FileError(path, std::string("cannot be made a grid: ") + error.what());
  }
}

}  // namespace

Map loadMap(const std::string& path, const LoadOptions& options) {
  const std::string extension = pathExtension(path);
  try {
    if (extension == ".gridmap" || extension == ".gridmap.gz") {
      return loadGridmap(path);
    }
    if (extension == ".simplemap" || extension == ".simplemap.gz") {
      return loadSimplemap(path);
    }
    if (isYamlPath(path)) {
      return loadRosMap(path);
    }
    if (isImagePath(path)) {
      if (!options.resolution) {
        throw FileError(path, "an image alone needs the size of its cells (--resolution METRES)");
      }
      return loadImageMap(path, *options.resolution);
    }
  } catch (const std::bad_alloc&) {
    throw FileError(path, "the map does not fit into memory");
  }
  checkReadable(path);
  throw FileError(path,
                  "is no map by its name: .gridmap[.gz], .simplemap[.gz], .yaml or an image (.png, "
                  ".pgm, .bmp, .jpg, .tif) can be read");
}

std::vector<std::string> filesRead(const std::string& path) {
  std::vector<std::string> files{path};
  if (isYamlPath(path)) {
    try {
      files.push_back(rosImagePath(path, loadRosYaml(path)));
    } catch (const FileError&) {
    }
  }
  return files;
}

}  // namespace sbox
