// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/gridmap_header.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

#include "sbox/io/file_error.h"
#include "sbox/io/map_checks.h"

namespace sbox {
namespace {

/// Reads MRPT's little-endian values one after another.
class Cursor {
 public:
  Cursor(const std::string& path, const Bytes& bytes) : path_(path), bytes_(bytes) {}

  std::uint8_t byte() {
    if (position_ >= bytes_.size()) {
      throw FileError(path_, "ends within its header: the file is truncated");
    }
    return bytes_[position_++];
  }
  std::uint32_t integer() {
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
      value |= static_cast<std::uint32_t>(byte()) << shift;
    }
    return value;
  }
  float real() {
    static_assert(sizeof(float) == 4);
    const std::uint32_t bits = integer();
    float value = 0;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
  std::string text(std::size_t length) {
    std::string value;
    while (value.size() < length) {
      value.push_back(static_cast<char>(byte()));
    }
    return value;
  }

 private:
  const std::string& path_;
  const Bytes& bytes_;
  std::size_t position_ = 0;
};

bool isClassName(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == ':' || c == '<' || c == '>';
  });
}

/// An object starts with its class name, the length of which has the top bit set, and the version
/// of the class, which is returned.
int readClass(const std::string& path, Cursor& cursor) {
  const std::uint8_t length = cursor.byte();
  if ((length & 0x80) == 0) {
    throw FileError(path, "is not an MRPT grid map file");
  }
  const std::string name = cursor.text(length & 0x7F);
  if (!isClassName(name)) {
    throw FileError(path, "is not an MRPT grid map file");
  }
  if (name != "mrpt::maps::COccupancyGridMap2D" && name != "COccupancyGridMap2D") {
    throw FileError(path, "holds an MRPT object of class " + name + ", not an occupancy grid");
  }
  const int version = cursor.byte();
  if (version < 3 || version > 6) {
    throw FileError(path, "has version " + std::to_string(version) +
                              " of MRPT's occupancy grid; versions 3 to 6 can be read");
  }
  return version;
}

}  // namespace

std::size_t gridmapHeaderSize(std::uint8_t first_byte) {
  constexpr std::size_t numbers = 2 * sizeof(std::uint32_t) + 5 * sizeof(float);
  const std::size_t class_name = first_byte & 0x7FU;
  return 1 + class_name + 1 /* version */ + 1 /* bits of a cell */ + numbers;
}

GridmapHeader readGridmapHeader(const std::string& path, const Bytes& header_bytes) {
  Cursor cursor(path, header_bytes);
  GridmapHeader header;
  header.version = readClass(path, cursor);
  if (const int bits = cursor.byte(); bits != 8) {
    throw FileError(path,
                    "has cells of " + std::to_string(bits) + " bits; only 8 bits can be read");
  }
  header.width = cursor.integer();
  header.height = cursor.integer();
  header.x_min = cursor.real();
  const float x_max = cursor.real();
  header.y_min = cursor.real();
  const float y_max = cursor.real();
  header.resolution = cursor.real();

  checkMapSize(path, header.width, header.height);
  checkResolution(path, header.resolution);
  if (!std::isfinite(header.x_min) || !std::isfinite(x_max) || !std::isfinite(header.y_min) ||
      !std::isfinite(y_max)) {
    throw FileError(path, "has a position that is no number");
  }
  checkCorner(path, {header.x_min, header.y_min, 0});
  // saveGridmap may be a quarter of a cell off; far from zero, floats are off by several.
  const auto contradicts = [&](double min, double max, std::uint32_t cells) {
    const double tolerance = 0.75 + 1e-6 * (std::abs(min) + std::abs(max)) / header.resolution;
    return std::abs((max - min) / header.resolution - cells) > tolerance;
  };
  if (contradicts(header.x_min, x_max, header.width) ||
      contradicts(header.y_min, y_max, header.height)) {
    throw FileError(path, "contradicts itself: its extents do not fit its number of cells");
  }
  return header;
}

}  // namespace sbox
