// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/save_map.h"

#include <filesystem>

#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"
#include "sbox/io/gridmap_file.h"
#include "sbox/io/path_extension.h"
#include "sbox/io/ros_map_file.h"

namespace sbox {
namespace {

/// Stages the target and writes it; an error names the target, not the temporary file.
template <typename Write>
void writeStaged(OutputFiles& files, const std::string& target, const Write& write) {
  const std::string temporary = files.stage(target);
  try {
    write(temporary);
  } catch (const FileError& error) {
    throw FileError(target, error.reason());
  }
}

void saveRosMap(const Map& map, const std::string& path, OutputFiles& files) {
  const std::filesystem::path image = std::filesystem::path(path).replace_extension(".pgm");
  writeStaged(files, image.string(),
              [&](const std::string& temporary) { saveGreyImage(rosPicture(map), temporary); });
  const std::string text = rosMapText(map, image.filename().string());
  writeStaged(files, path, [&](const std::string& temporary) {
    writeFile(temporary, Bytes(text.begin(), text.end()));
  });
}

}  // namespace

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
                    "cannot be written: a map's name ends in .gridmap, .gridmap.gz, .yaml, "
                    ".png or .pgm");
  }
  const std::string extension = pathExtension(path);
  if (extension == ".yaml" || extension == ".yml") {
    saveRosMap(map, path, files);
  } else if (extension == ".png" || extension == ".pgm") {
    writeStaged(files, path,
                [&](const std::string& temporary) { saveGreyImage(rosPicture(map), temporary); });
  } else {
    writeStaged(files, path, [&](const std::string& temporary) { saveGridmap(map, temporary); });
  }
}

}  // namespace sbox
