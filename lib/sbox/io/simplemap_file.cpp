// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/simplemap_file.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <new>
#include <stdexcept>

#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"

namespace sbox {

using mrpt::maps::CSimpleMap;

KeyFrames keyFramesOf(const CSimpleMap& map) {
  KeyFrames key_frames;
  for (const auto& entry : map) {
    if (!entry.pose || !entry.sf) {
      throw std::invalid_argument("a key frame without pose or observations");
    }
    const mrpt::poses::CPose3D mean = entry.pose->getMeanVal();
    for (const double value :
         {mean.x(), mean.y(), mean.z(), mean.yaw(), mean.pitch(), mean.roll()}) {
      if (!std::isfinite(value)) {
        throw std::invalid_argument("a key frame whose pose is no number");
      }
    }
    key_frames.push_back({entry.pose, entry.sf});
  }
  return key_frames;
}

KeyFrames loadKeyFrames(const std::string& path) {
  checkReadable(path);
  mrpt::io::CFileGZInputStream in;
  if (!in.open(path)) {
    throw FileError(path, "cannot be read");
  }
  CSimpleMap map;
  try {
    mrpt::serialization::archiveFrom(in) >> map;
  } catch (const std::bad_alloc&) {
    throw FileError(path, "does not fit into memory, or is damaged");
  } catch (const std::exception&) {
    // MRPT's own text is many lines long, with a backtrace.
    throw FileError(path,
                    "is damaged, or was written by a newer MRPT than this one, or is no "
                    "simplemap at all");
  }
  try {
    return keyFramesOf(map);
  } catch (const std::invalid_argument& error) {
    throw FileError(path, std::string("is damaged: it holds ") + error.what());
  }
}

void saveKeyFrames(const KeyFrames& key_frames, const std::string& path) {
  CSimpleMap map;
  for (const KeyFrame& key_frame : key_frames) {
    map.insert(key_frame.robot_in_map, key_frame.seen);
  }
  {
    mrpt::io::CFileGZOutputStream out;
    if (!out.open(path)) {
      throw FileError(path, "cannot be written");
    }
    try {
      mrpt::serialization::archiveFrom(out) << map;
    } catch (const std::exception&) {
      throw FileError(path, "cannot be written in full: is the disk full?");
    }
  }
  // MRPT does not tell when the last bytes of a compressed file could not be written.
  try {
    if (loadKeyFrames(path).size() == key_frames.size()) {
      return;
    }
  } catch (const FileError&) {
  }
  throw FileError(path, "cannot be written in full: is the disk full?");
}

}  // namespace sbox
