// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/save_map.h"

#include <filesystem>

#include "sbox/io/file_error.h"
#include "sbox/io/gridmap_file.h"
#include "sbox/io/path_extension.h"
#include "sbox/io/ros_map_file.h"

namespace sbox {
namespace {

std::filesystem::path imageBeside(const std::string& yaml) {
  return std::filesystem::path(yaml).replace_extension(".pgm");
}

void saveRosMap(const Map& map, const std::string& path, OutputFiles& files) {
  const std::filesystem::path image = imageBeside(path);
  files.write(image.string(),
              [&](const std::string& temporary) { saveGreyImage(rosPicture(map), temporary); });
  files.writeBytes(path, rosMapText(map, image.filename().string()));
}

}  // namespace

std::vector<std::string> filesOfMap(const std::string& path) {
  return isYamlPath(path) ? std::vector<std::string>{path, imageBeside(path).string()}
                          : std::vector<std::string>{path};
}

bool canSaveMap(const std::string& path) {
  const std::string extension = pathExtension(path);
  for (const char* known : {".gridmap", ".gridmap.gz", ".yaml", ".yml", ".png", ".pgm"}) {
    if (extension == known) {
      return true;
    }
  }
  return false;
}

void saveMap(const Map& map, const std::string& path) {
  OutputFiles files;
  saveMap(map, path, files);
  files.commit();
}

void saveMap(const Map& map, const std::string& path, OutputFiles& files) {
  if (!canSaveMap(path)) {
    throw FileError(path,
                    "cannot be written: a map's name ends in .gridmap, .gridmap.gz, .yaml, .yml, "
                    ".png or .pgm");
  }
  const std::string extension = pathExtension(path);
  if (isYamlPath(path)) {
    saveRosMap(map, path, files);
  } else if (extension == ".png" || extension == ".pgm") {
    files.write(path,
                [&](const std::string& temporary) { saveGreyImage(rosPicture(map), temporary); });
  } else {
    files.write(path, [&](const std::string& temporary) { saveGridmap(map, temporary); });
  }
}

}  // namespace sbox
