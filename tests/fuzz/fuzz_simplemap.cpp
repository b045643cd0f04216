// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a .simplemap that a process of its own survives reading, as sbox-merge asks first:
// key frames or a FileError; and those that were read are written, read back and mapped.
#include <stdexcept>

#include "fuzz/input_folder.h"
#include "fuzz/quiet_death.h"
#include "sbox-merge/trial_reading.h"
#include "sbox/io/file_error.h"
#include "sbox/io/simplemap_file.h"
#include "sbox/mapping/map_key_frames.h"

using namespace sbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFolder folder;
  const std::string path = folder.write("in.simplemap", {data, data + size});
  KeyFrames key_frames;
  try {
    app::tryReading(path, [&] {
      fuzz::dieQuietly();
      static_cast<void>(loadKeyFrames(path));
    });
    key_frames = loadKeyFrames(path);
  } catch (const FileError&) {
    return 0;
  }
  const std::string again = folder.path("again.simplemap");
  saveKeyFrames(key_frames, again);
  fuzz::require(loadKeyFrames(again).size() == key_frames.size());
  try {
    const Map map = mapKeyFrames("map", key_frames);
    fuzz::require(map.width() > 0 && map.height() > 0);
  } catch (const std::invalid_argument&) {
    // No scan of use.
  } catch (const std::length_error&) {
    // Poses too far apart.
  }
  return 0;
}
