// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/serialization/CArchive.h>

#include <cstring>
#include <random>

#include "catch.h"
#include "io/contains.h"
#include "io/scratch_folder.h"
#include "io/test_maps.h"
#include "sbox/io/file_error.h"
#include "sbox/io/gridmap_file.h"

using namespace sbox;

namespace {

using mrpt::serialization::archiveFrom;

/// The plain bytes of a compressed file.
std::string decompressed(const std::string& path) {
  mrpt::io::CFileGZInputStream in(path);
  std::string bytes(1 << 20, '\0');
  bytes.resize(in.Read(bytes.data(), bytes.size()));
  return bytes;
}

/// The plain bytes of a map's file: version at byte 32, bits a cell at 33, sizes at 34 and 38,
/// extents at 42, 46, 50 and 54, resolution at 58, then the cells.
std::string fileBytes(const ScratchFolder& folder, const Map& map) {
  saveGridmap(map, folder.path("whole.gridmap"));
  return decompressed(folder.path("whole.gridmap"));
}

template <typename Value>
std::string changed(std::string bytes, std::size_t at, Value value) {
  std::string binary(sizeof(value), '\0');
  std::memcpy(binary.data(), &value, sizeof(value));
  return bytes.replace(at, binary.size(), binary);
}

std::string reasonOf(const ScratchFolder& folder, const std::string& contents) {
  try {
    static_cast<void>(loadGridmap(folder.write("bad.gridmap", contents)));
  } catch (const FileError& error) {
    CHECK(error.path() == folder.path("bad.gridmap"));
    return error.reason();
  }
  return "was read";
}

}  // namespace

TEST_CASE("MRPT reads what we write", "[gridmap_file]") {
  const ScratchFolder folder;
  const Pose2D corner = GENERATE(Pose2D{-3, 2, 0}, Pose2D{0.025, -1.025, 0},
                                 Pose2D{-51.224998, 123.475, 0}, Pose2D{5000.01, -20000.03, 0});
  const double resolution = GENERATE(0.02, 0.05);
  const Map map = randomMap(41, 30, resolution, corner);
  saveGridmap(map, folder.path("a.gridmap"));
  mrpt::io::CFileGZInputStream in(folder.path("a.gridmap"));
  mrpt::maps::COccupancyGridMap2D grid;
  archiveFrom(in) >> grid;
  CHECK(grid.getSizeX() == 41);
  CHECK(grid.getSizeY() == 30);
  CHECK(grid.getResolution() == map.grid.getResolution());
  CHECK(grid.getRawMap() == map.grid.getRawMap());
  CHECK(grid.getXMin() == Approx(corner.x).margin(0.5 * resolution + 0.002));
  CHECK(grid.getYMin() == Approx(corner.y).margin(0.5 * resolution + 0.002));
}

TEST_CASE("we read what MRPT writes", "[gridmap_file]") {
  const ScratchFolder folder;
  mrpt::maps::COccupancyGridMap2D grid(-1.5F, 2.0F, 10.0F, 11.0F, 0.25F);
  grid.setCell(3, 1, 0.1F);
  {
    mrpt::io::CFileGZOutputStream out(folder.path("a.gridmap"));
    archiveFrom(out) << grid;
  }
  const Map map = loadGridmap(folder.path("a.gridmap"));
  CHECK(map.name == folder.path("a.gridmap"));
  CHECK(map.width() == 14);
  CHECK(map.height() == 4);
  CHECK(map.grid.getRawMap() == grid.getRawMap());
  CHECK(map.corner_in_map.x == -1.5);
  CHECK(map.corner_in_map.y == 10);
  CHECK(map.corner_in_map.phi == 0);
}

TEST_CASE("a file need not be compressed", "[gridmap_file]") {
  const ScratchFolder folder;
  const Map map = randomMap(20, 10, 0.1, {1, 2, 0});
  const Map read = loadGridmap(folder.write("plain.gridmap.gz", fileBytes(folder, map)));
  CHECK(read.grid.getRawMap() == map.grid.getRawMap());
}

TEST_CASE("a file cut off anywhere is refused", "[gridmap_file]") {
  const ScratchFolder folder;
  const std::string plain = fileBytes(folder, randomMap(20, 10, 0.1, {}));
  const bool compressed = GENERATE(false, true);
  const std::string whole = compressed ? folder.read("whole.gridmap") : plain;
  REQUIRE(reasonOf(folder, whole) == "was read");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    INFO(size << " of " << whole.size() << " bytes");
    CHECK(reasonOf(folder, whole.substr(0, size)) != "was read");
  }
}

TEST_CASE("a damaged compressed file is never read wrongly", "[gridmap_file]") {
  const ScratchFolder folder;
  const Map map = randomMap(20, 10, 0.1, {});
  saveGridmap(map, folder.path("whole.gridmap"));
  const std::string whole = folder.read("whole.gridmap");
  std::size_t refused = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    INFO("byte " << at);
    const std::string damaged = changed(whole, at, static_cast<char>(whole[at] ^ 0x10));
    try {
      const Map read = loadGridmap(folder.write("bad.gridmap", damaged));
      CHECK(read.grid.getRawMap() == map.grid.getRawMap());
    } catch (const FileError&) {
      ++refused;
    }
  }
  // A time stamp and unused bits may change without harm.
  CHECK(refused > whole.size() - 10);
}

TEST_CASE("a header that makes no sense is refused", "[gridmap_file]") {
  const ScratchFolder folder;
  const std::string whole = fileBytes(folder, randomMap(20, 10, 0.1, {1, 2, 0}));
  const float nan = std::nanf("");
  CHECK(reasonOf(folder, changed<std::uint32_t>(whole, 34, 0)) == "has no cells (0 x 10 cells)");
  CHECK(contains(reasonOf(folder, changed<std::uint32_t>(whole, 34, 100'000'000)),
                 "claims 100000000 x 10 cells, more than"));
  CHECK(contains(reasonOf(folder, changed<std::uint32_t>(whole, 34, 4'294'967'295)),
                 "claims 4294967295 x 10 cells, more than"));
  CHECK(contains(reasonOf(folder, changed<std::uint32_t>(whole, 34, 21)), "extents"));
  CHECK(contains(reasonOf(folder, changed(whole, 42, nan)), "no number"));
  CHECK(contains(reasonOf(folder, changed(whole, 54, HUGE_VALF)), "no number"));
  CHECK(contains(reasonOf(folder, changed(whole, 58, nan)), "resolution nan m"));
  CHECK(contains(reasonOf(folder, changed(whole, 58, 0.0F)), "resolution 0 m"));
  CHECK(contains(reasonOf(folder, changed(whole, 58, -0.1F)), "resolution -0.1"));
  CHECK(contains(reasonOf(folder, changed<char>(whole, 32, 7)), "version 7"));
  CHECK(contains(reasonOf(folder, changed<char>(whole, 33, 16)), "16 bits"));
}

TEST_CASE("a header that claims many cells takes no memory for them", "[gridmap_file]") {
  const ScratchFolder folder;
  std::string bytes = fileBytes(folder, randomMap(20, 10, 0.1, {}));
  bytes = changed<std::uint32_t>(changed<std::uint32_t>(bytes, 34, 19'000), 38, 19'000);
  bytes = changed(changed(changed(bytes, 46, 1900.0F), 54, 1900.0F), 42, 0.0F);
  CHECK(contains(reasonOf(folder, bytes), "truncated"));
}

TEST_CASE("an MRPT object of another class is named", "[gridmap_file]") {
  const ScratchFolder folder;
  {
    mrpt::io::CFileGZOutputStream out(folder.path("points.gridmap"));
    archiveFrom(out) << mrpt::maps::CSimplePointsMap();
  }
  CHECK_THROWS_WITH(loadGridmap(folder.path("points.gridmap")),
                    folder.path("points.gridmap") +
                        ": holds an MRPT object of class mrpt::maps::CSimplePointsMap, not an "
                        "occupancy grid");
}

TEST_CASE("random bytes are no grid map", "[gridmap_file]") {
  const ScratchFolder folder;
  const std::string start = GENERATE("", "\x1f\x8b\x08", "\x9fmrpt::maps::COccupancyGridMap2D\x06");
  std::mt19937 random(13);
  for (int round = 0; round < 50; ++round) {
    std::string contents = start;
    for (int i = 0; i < 200; ++i) {
      contents.push_back(static_cast<char>(random() % 256));
    }
    CHECK(reasonOf(folder, contents) != "was read");
  }
}

TEST_CASE("MRPT's own old grid maps are read", "[gridmap_file]") {
  const std::string path = "/usr/share/mrpt/datasets/2006-MalagaCampus.gridmap.gz";
  if (!std::filesystem::exists(path)) {
    WARN("skipped: " << path << " is not installed (package mrpt-common)");
    return;
  }
  const Map map = loadGridmap(path);
  CHECK(map.width() == 1888);
  CHECK(map.height() == 2738);
  CHECK(map.grid.getResolution() == 0.08F);
}
