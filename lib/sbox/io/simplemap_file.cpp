// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/simplemap_file.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <stdexcept>

#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"
#include "sbox/mapping/sound_pose.h"

namespace sbox {

using mrpt::maps::CSimpleMap;

namespace {

/// MRPT makes room for all the key frames that a file claims to hold before it reads the first.
/// Throws FileError if there are more than the file can hold, were it compressed as well as can be.
void checkCount(mrpt::io::CFileGZInputStream& in, const std::string& path, std::uint64_t bytes) {
  auto archive = mrpt::serialization::archiveFrom(in);
  // The name of its class behind the name's length, whose highest bit is set; then the version.
  const auto name_length = archive.ReadAs<std::uint8_t>();
  std::array<char, 128> name{};
  archive.ReadBuffer(name.data(), name_length & 0x7FU);
  archive.ReadAs<std::uint8_t>();
  constexpr std::uint64_t least_bytes = 16, best_compression = 1032;
  if (archive.ReadAs<std::uint32_t>() > bytes * best_compression / least_bytes) {
    throw FileError(path, "is damaged: it claims to hold more key frames than fit into it");
  }
}

}  // namespace

KeyFrames keyFramesOf(const CSimpleMap& map) {
  KeyFrames key_frames;
  for (const auto& entry : map) {
    if (!entry.pose || !entry.sf ||
        std::find(entry.sf->begin(), entry.sf->end(), nullptr) != entry.sf->end()) {
      throw std::invalid_argument("a key frame without pose or observations");
    }
    if (!isSound(entry.pose->getMeanVal())) {
      throw std::invalid_argument("a key frame whose pose makes no sense");
    }
    key_frames.push_back({entry.pose, entry.sf});
  }
  return key_frames;
}

KeyFrames loadKeyFrames(const std::string& path) {
  const std::uint64_t bytes = checkReadable(path);
  CSimpleMap map;
  try {
    mrpt::io::CFileGZInputStream head(path), whole(path);
    checkCount(head, path, bytes);
    mrpt::serialization::archiveFrom(whole) >> map;
  } catch (const FileError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw FileError(path, no_memory);
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
