// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as an image: a map or a FileError. The checksums of a PNG are put right first, which a
// mutation would nearly never hit.
#include <algorithm>

#include "fuzz/input_folder.h"
#include "sbox/io/byte_order.h"
#include "sbox/io/file_error.h"
#include "sbox/io/ros_map_file.h"

using namespace sbox;

namespace {

/// CRC-32, bit by bit.
std::uint32_t checksum(const std::uint8_t* bytes, std::size_t size) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 1) != 0 ? 0xEDB88320U ^ (crc >> 1) : crc >> 1;
    }
  }
  return crc ^ 0xFFFFFFFFU;
}

void rightChecksums(Bytes& png) {
  constexpr std::size_t signature = 8, frame = 12;
  if (png.size() < signature || png[1] != 'P' || png[2] != 'N' || png[3] != 'G') {
    return;
  }
  for (std::size_t at = signature; at + frame <= png.size();) {
    const std::uint32_t length = bigEndian32(png, at);
    if (length > png.size() - at - frame) {
      return;
    }
    const std::uint32_t crc = checksum(png.data() + at + 4, length + 4);
    for (unsigned i = 0; i < 4; ++i) {
      png[at + 8 + length + i] = static_cast<std::uint8_t>(crc >> (24 - 8 * i));
    }
    at += frame + length;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFolder folder;
  Bytes bytes(data, data + size);
  rightChecksums(bytes);
  try {
    const Map map = loadImageMap(folder.write("in.png", bytes), 0.05);
    fuzz::require(map.width() > 0 && map.height() > 0);
  } catch (const FileError&) {
  }
  return 0;
}
