// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "sbox/io/file_bytes.h"

namespace sbox {

/// What a grid map file says before its cells.
struct GridmapHeader {
  int version = 0;           ///< Of MRPT's class.
  std::uint32_t width = 0;   ///< Cells in a row.
  std::uint32_t height = 0;  ///< Cells in a column.
  float x_min = 0;           ///< Lower-left corner of the grid, in metres.
  float y_min = 0;           ///< Lower edge of row 0, metres.
  float resolution = 0;      ///< Edge length of a cell, in metres.
};

/// Bytes from the start of the object to its cells, as told by its first byte.
[[nodiscard]] std::size_t gridmapHeaderSize(std::uint8_t first_byte);

/// Reads the header at the start of a serialised MRPT object. Throws FileError naming `path` if it
/// is no occupancy grid of a known version or if its sizes or its position make no sense.
[[nodiscard]] GridmapHeader readGridmapHeader(const std::string& path, const Bytes& header_bytes);

}  // namespace sbox
