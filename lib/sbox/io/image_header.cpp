// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/image_header.h"

#include <cmath>
#include <cstring>
#include <string_view>

#include "sbox/io/byte_order.h"
#include "sbox/io/pnm_image.h"

namespace sbox {
namespace {

/// Deflate makes no less than one byte out of this many.
constexpr double max_deflate_ratio = 1032;
/// A JPEG's block of 64 pixels takes a bit at the least, so a byte holds 512; twice that, to be
/// sure.
constexpr std::int64_t max_jpeg_ratio = 1024;

bool startsWith(const Bytes& bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

std::optional<ImageHeader> readPngHeader(const Bytes& bytes) {
  if (bytes.size() < 29) {
    return std::nullopt;
  }
  ImageHeader header{ImageKind::Png, bigEndian32(bytes, 16), bigEndian32(bytes, 20)};
  const int bit_depth = bytes[24], colour_type = bytes[25];
  const int channels = colour_type == 2 ? 3 : colour_type == 4 ? 2 : colour_type == 6 ? 4 : 1;
  // Each row begins with the number of its filter.
  const double row_size = 1 + std::ceil(1.0 * bit_depth * channels * bigEndian32(bytes, 16) / 8);
  header.whole = row_size * static_cast<double>(header.height) <=
                 max_deflate_ratio * static_cast<double>(bytes.size());
  return header;
}

std::optional<ImageHeader> readBmpHeader(const Bytes& bytes) {
  if (bytes.size() < 54) {
    return std::nullopt;
  }
  const std::int64_t width = static_cast<std::int32_t>(littleEndian32(bytes, 18));
  // Negative where the top row comes first.
  const std::int64_t height = static_cast<std::int32_t>(littleEndian32(bytes, 22));
  ImageHeader header{ImageKind::Other, width, height < 0 ? -height : height};
  // In doubles: what the header claims may be beyond integers.
  const double bits = littleEndian16(bytes, 28);
  const double row_size = std::floor((static_cast<double>(width) * bits + 31) / 32) * 4;
  const double end = littleEndian32(bytes, 10) + row_size * static_cast<double>(header.height);
  const bool compressed = littleEndian32(bytes, 30) != 0;
  header.whole = compressed || static_cast<double>(bytes.size()) >= end;
  return header;
}

/// The size stands in the frame segment (SOF0 to SOF15, without the tables that share its numbers).
std::optional<ImageHeader> readJpegHeader(const Bytes& bytes) {
  for (std::size_t at = 2; at + 9 <= bytes.size();) {
    const std::uint8_t marker = bytes[at + 1];
    if (bytes[at] != 0xFF) {
      return std::nullopt;
    }
    if (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC) {
      ImageHeader header{ImageKind::Other, bigEndian16(bytes, at + 7), bigEndian16(bytes, at + 5)};
      const bool ended = bytes[bytes.size() - 2] == 0xFF && bytes[bytes.size() - 1] == 0xD9;
      header.whole = ended && header.width * header.height <=
                                  max_jpeg_ratio * static_cast<std::int64_t>(bytes.size());
      return header;
    }
    at += 2U + bigEndian16(bytes, at + 2);
  }
  return std::nullopt;
}

/// The first directory of tags: 12 bytes each, width is tag 256 and height tag 257.
std::optional<ImageHeader> readTiffHeader(const Bytes& bytes) {
  const bool little = bytes[0] == 'I';
  const auto u16 = [&](std::size_t at) {
    return little ? littleEndian16(bytes, at) : bigEndian16(bytes, at);
  };
  const auto u32 = [&](std::size_t at) {
    return little ? littleEndian32(bytes, at) : bigEndian32(bytes, at);
  };
  if (bytes.size() < 8) {
    return std::nullopt;
  }
  const std::size_t directory = u32(4);
  if (directory + 2 > bytes.size()) {
    return std::nullopt;
  }
  const std::size_t count = u16(directory);
  ImageHeader header;
  for (std::size_t at = directory + 2; at < directory + 2 + 12 * count; at += 12) {
    if (at + 12 > bytes.size()) {
      return std::nullopt;
    }
    const std::uint16_t tag = u16(at);
    if (tag == 256 || tag == 257) {
      constexpr std::uint16_t short_type = 3;
      (tag == 256 ? header.width : header.height) =
          u16(at + 2) == short_type ? u16(at + 8) : u32(at + 8);
    }
  }
  return header;
}

}  // namespace

std::optional<ImageHeader> readImageHeader(const Bytes& bytes) {
  using namespace std::string_view_literals;
  if (startsWith(bytes, "\x89PNG\r\n\x1a\n"sv)) {
    return readPngHeader(bytes);
  }
  if (isPnm(bytes)) {
    return readPnmHeader(bytes);
  }
  if (startsWith(bytes, "BM"sv)) {
    return readBmpHeader(bytes);
  }
  if (startsWith(bytes, "\xFF\xD8\xFF"sv)) {
    return readJpegHeader(bytes);
  }
  if (startsWith(bytes, "II*\0"sv) || startsWith(bytes, "MM\0*"sv)) {
    return readTiffHeader(bytes);
  }
  return std::nullopt;
}

}  // namespace sbox
