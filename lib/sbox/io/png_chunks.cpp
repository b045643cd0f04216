// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/png_chunks.h"

#include <array>

#include "sbox/io/byte_order.h"
#include "sbox/io/file_error.h"

namespace sbox {
namespace {

/// CRC-32 of the PNG specification, annex D.
std::uint32_t checksum(const std::uint8_t* bytes, std::size_t size) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> values{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit) {
        value = (value & 1) != 0 ? 0xEDB88320U ^ (value >> 1) : value >> 1;
      }
      values[i] = value;
    }
    return values;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (std::size_t i = 0; i < size; ++i) {
    crc = table[(crc ^ bytes[i]) & 0xFF] ^ (crc >> 8);
  }
  return crc ^ 0xFFFFFFFFU;
}

}  // namespace

Bytes essentialPngChunks(const std::string& path, const Bytes& png) {
  constexpr std::size_t signature_size = 8;
  constexpr std::size_t frame_size = 12;  // length, type and checksum of a chunk
  Bytes essential(png.begin(), png.begin() + signature_size);
  essential.reserve(png.size());
  for (std::size_t at = signature_size; at + frame_size <= png.size();) {
    const std::uint32_t length = bigEndian32(png, at);
    if (length > png.size() - at - frame_size) {
      break;
    }
    const std::string type(png.begin() + static_cast<std::ptrdiff_t>(at + 4),
                           png.begin() + static_cast<std::ptrdiff_t>(at + 8));
    if (checksum(png.data() + at + 4, length + 4) != bigEndian32(png, at + 8 + length)) {
      throw FileError(path, "is damaged: its chunk " + type + " fails its checksum");
    }
    const bool critical = type[0] >= 'A' && type[0] <= 'Z';
    if (critical || type == "tRNS") {
      essential.insert(essential.end(), png.begin() + static_cast<std::ptrdiff_t>(at),
                       png.begin() + static_cast<std::ptrdiff_t>(at + frame_size + length));
    }
    if (type == "IEND") {
      return essential;
    }
    at += frame_size + length;
  }
  throwTruncated(path, "image");
}

}  // namespace sbox
