// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/gridmap_file.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <array>
#include <cmath>
#include <fstream>
#include <optional>

#include "sbox/io/align_to_axes.h"
#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"
#include "sbox/io/gridmap_header.h"
#include "sbox/io/gzip_reader.h"

namespace sbox {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;
static_assert(sizeof(Grid::cellType) == 1, "MRPT was built with 16-bit cells");

/// The last byte of a serialised MRPT object.
constexpr std::uint8_t end_flag = 0x88;
/// Bytes of MRPT's options after the cells: about 500.
constexpr std::size_t max_options_size = 1 << 20;
/// Deflate makes no less than one byte out of this many.
constexpr std::uint64_t max_compression = 1032;

/// Decompressed size that a gzip file states in its last four bytes; nothing for a plain file.
std::optional<std::uint32_t> statedSize(const std::string& path, std::uint64_t file_size) {
  std::array<std::uint8_t, 4> bytes{};
  std::ifstream in(path, std::ios::binary);
  in.read(reinterpret_cast<char*>(bytes.data()), 2);
  if (!in || bytes[0] != 0x1F || bytes[1] != 0x8B || file_size < 18) {
    return std::nullopt;
  }
  in.seekg(-4, std::ios::end);
  in.read(reinterpret_cast<char*>(bytes.data()), 4);
  std::uint32_t size = 0;
  for (unsigned i = 0; i < 4; ++i) {
    size |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
  }
  return size;
}

/// Reads MRPT's options, which matter to its own SLAM only, to be sure that the file is whole.
void checkRest(const std::string& path, std::uint64_t file_size, int version, GzipReader& reader) {
  Bytes options(max_options_size);
  const std::size_t size = reader.read(options.data(), options.size());
  if (size == 0 || options[size - 1] != end_flag) {
    throwTruncated(path, "file");
  }
  // From version 6 on there is an object within the options, whose own flag must not be taken for
  // the last one: two floats and a truth value lie between them.
  constexpr std::size_t nested_flag = 2 * sizeof(float) + 1 + 2;
  if (version >= 6 && (size < nested_flag || options[size - nested_flag] != end_flag)) {
    throwTruncated(path, "file");
  }
  // A wrong checksum comes to light only when there is no more to read.
  if (reader.read(options.data(), options.size()) != 0) {
    throw FileError(path, "is damaged: there is more in it than a grid map");
  }
  const std::optional<std::uint32_t> stated = statedSize(path, file_size);
  if (stated && *stated != static_cast<std::uint32_t>(reader.total())) {
    throwTruncated(path, "file");
  }
}

/// A copy of a grid at a place that MRPT would round to a multiple of the cell size.
class PlacedGrid : public Grid {
 public:
  PlacedGrid(const Grid& cells, float x_min, float x_max, float y_min, float y_max) : Grid(cells) {
    m_xMin = x_min;
    m_xMax = x_max;
    m_yMin = y_min;
    m_yMax = y_max;
  }
};

/// Cells that MRPT's reader will count between two coordinates, or 0 if it refuses them. It rounds
/// both to whole cells, in floats.
unsigned countedCells(float min, float max, float resolution) {
  try {
    return Grid(min, max, 0, resolution, resolution).getSizeX();
  } catch (const std::exception&) {
    return 0;
  }
}

/// An upper coordinate with which MRPT's reader counts the cells right. Nothing but that count
/// depends on it, so a quarter of a cell more or less does no harm.
float upperCoordinate(const std::string& path, float min, float resolution, int cells) {
  for (const double shift : {0.0, 0.25, -0.25}) {
    const auto max = static_cast<float>(min + (cells + shift) * static_cast<double>(resolution));
    if (countedCells(min, max, resolution) == static_cast<unsigned>(cells)) {
      return max;
    }
  }
  throw FileError(path,
                  "the map lies too far from its frame's origin for a .gridmap file, which stores "
                  "it in floats; write a .yaml instead");
}

void writeGridmap(const Map& map, const std::string& path) {
  const auto x_min = static_cast<float>(map.corner_in_map.x);
  const auto y_min = static_cast<float>(map.corner_in_map.y);
  const float cell = map.grid.getResolution();
  const PlacedGrid grid(map.grid, x_min, upperCoordinate(path, x_min, cell, map.width()), y_min,
                        upperCoordinate(path, y_min, cell, map.height()));
  mrpt::io::CFileGZOutputStream out;
  if (!out.open(path)) {
    throw FileError(path, "cannot be written");
  }
  try {
    mrpt::serialization::archiveFrom(out) << grid;
  } catch (const std::exception&) {
    // MRPT's own text is many lines long, with a backtrace.
    throw FileError(path, "cannot be written in full: is the disk full?");
  }
}

/// MRPT does not tell when the last bytes of a compressed file could not be written.
void checkWritten(const Map& map, const std::string& path) {
  try {
    const Map written = loadGridmap(path);
    if (written.grid.getRawMap() == map.grid.getRawMap()) {
      return;
    }
  } catch (const FileError&) {
  }
  throw FileError(path, "cannot be written in full: is the disk full?");
}

}  // namespace

Map loadGridmap(const std::string& path) {
  const std::uint64_t file_size = checkReadable(path);
  GzipReader reader(path);
  Bytes start(1);
  start.resize(reader.read(start.data(), 1));
  if (!start.empty()) {
    start.resize(gridmapHeaderSize(start[0]));
    start.resize(1 + reader.read(start.data() + 1, start.size() - 1));
  }
  const GridmapHeader header = readGridmapHeader(path, start);
  const std::size_t cells = static_cast<std::size_t>(header.width) * header.height;
  if (cells > file_size * max_compression) {
    throwTruncated(path, "file");
  }
  Map map = makeMap(path, static_cast<int>(header.width), static_cast<int>(header.height),
                    header.resolution, {header.x_min, header.y_min, 0});
  if (reader.read(map.grid.getRow(0), cells) < cells) {
    throwTruncated(path, "file");
  }
  checkRest(path, file_size, header.version, reader);
  return map;
}

void saveGridmap(const Map& map, const std::string& path) {
  if (wrapAngle(map.corner_in_map.phi) == 0) {
    writeGridmap(map, path);
    checkWritten(map, path);
  } else {
    const Map aligned = alignToAxes(map);
    writeGridmap(aligned, path);
    checkWritten(aligned, path);
  }
}

}  // namespace sbox
