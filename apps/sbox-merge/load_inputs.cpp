// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/load_inputs.h"

#include <stdexcept>

#include "sbox-merge/trial_reading.h"
#include "sbox/core/parallel.h"
#include "sbox/core/state_grid.h"
#include "sbox/io/file_error.h"
#include "sbox/io/load_map.h"
#include "sbox/io/path_extension.h"
#include "sbox/io/simplemap_file.h"
#include "sbox/mapping/map_key_frames.h"

namespace sbox::app {
namespace {

/// A map that no method could ever match is an input that cannot be used.
void checkUsable(const Map& map) {
  if (map.width() < 2 || map.height() < 2) {
    throw FileError(map.name, "is too small to match: it has " + std::to_string(map.width()) +
                                  " x " + std::to_string(map.height()) + " cells");
  }
  if (!hasOccupiedCell(map)) {
    throw FileError(map.name, "has no occupied cell, so there are no walls to match");
  }
}

/// Some outputs need more than a grid.
void checkScans(const std::string& path, const KeyFrames& key_frames, const Arguments& arguments) {
  if (!key_frames.empty()) {
    return;
  }
  const std::string advice = ": give its .simplemap or .rawlog";
  if (arguments.fuse_observations) {
    throw FileError(path, "holds no scans, which --fusion observations needs" + advice);
  }
  if (!arguments.simplemap.empty()) {
    throw FileError(path, "holds no scans, which --simplemap needs" + advice);
  }
}

Map mapScans(const std::string& path, const KeyFrames& key_frames, const Arguments& arguments) {
  try {
    return mapKeyFrames(path, key_frames, arguments.merge.mapping);
  } catch (const std::invalid_argument& error) {
    throw FileError(path, std::string("cannot be mapped: ") + error.what());
  } catch (const std::length_error& error) {
    throw FileError(path, std::string("cannot be mapped: ") + error.what());
  }
}

bool isSimplemap(const std::string& path) {
  const std::string extension = pathExtension(path);
  return extension == ".simplemap" || extension == ".simplemap.gz";
}

}  // namespace

bool isRawlog(const std::string& path) {
  const std::string extension = pathExtension(path);
  return extension == ".rawlog" || extension == ".rawlog.gz";
}

Inputs loadInputs(const Arguments& arguments, const RunSlams& run_slams,
                  const ProgressFunction& tell) {
  Inputs inputs{std::vector<Map>(arguments.inputs.size()),
                std::vector<KeyFrames>(arguments.inputs.size())};
  for (const std::string& path : arguments.inputs) {
    if (isSimplemap(path)) {
      tryReading(path, [&] { static_cast<void>(loadKeyFrames(path)); });
    }
  }
  run_slams(arguments, tell, inputs);
  const auto count = static_cast<int>(arguments.inputs.size());
  StageProgress progress(tell, "maps loaded", count);
  parallelFor(count, arguments.merge.threads, [&](int i) {
    progress.partBegins();
    const auto index = static_cast<size_t>(i);
    const std::string& path = arguments.inputs[index];
    KeyFrames& key_frames = inputs.key_frames[index];
    if (isSimplemap(path)) {
      key_frames = loadKeyFrames(path);
    }
    inputs.maps[index] = isSimplemap(path) || isRawlog(path)
                             ? mapScans(path, key_frames, arguments)
                             : loadMap(path, {arguments.resolution});
    checkUsable(inputs.maps[index]);
    checkScans(path, key_frames, arguments);
    progress.partDone();
  });
  return inputs;
}

}  // namespace sbox::app
