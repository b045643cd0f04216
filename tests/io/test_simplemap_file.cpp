// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/maps/CSimpleMap.h>

#include <cstdint>
#include <limits>

#include "catch.h"
#include "io/contains.h"
#include "io/scratch_folder.h"
#include "io/serialized.h"
#include "mapping/scanned_room.h"
#include "sbox/io/file_error.h"
#include "sbox/io/load_map.h"
#include "sbox/io/simplemap_file.h"
#include "sbox/mapping/map_key_frames.h"

using namespace sbox;
using namespace sbox::test;

namespace {

std::string errorOf(const std::string& path) {
  try {
    static_cast<void>(loadMap(path));
  } catch (const FileError& error) {
    CHECK(error.path() == path);
    CHECK_FALSE(contains(error.what(), "\n"));
    return error.reason();
  }
  return "was read";
}

}  // namespace

TEST_CASE("key frames come back as they were written", "[simplemap_file]") {
  const ScratchFolder folder;
  const std::string path = folder.path(GENERATE("a.simplemap", "a.simplemap.gz"));
  const Room room;
  const KeyFrames written{keyFrame(room, {}, {1, 2, 0.5}), keyFrame(room, {1, 0, 0}, {2, 2, 1})};
  saveKeyFrames(written, path);
  const KeyFrames read = loadKeyFrames(path);
  REQUIRE(read.size() == 2);
  for (size_t i = 0; i < 2; ++i) {
    CHECK(poseOf(read[i]).x == Approx(poseOf(written[i]).x));
    CHECK(poseOf(read[i]).y == Approx(poseOf(written[i]).y));
    CHECK(poseOf(read[i]).phi == Approx(poseOf(written[i]).phi));
    const auto& scan =
        dynamic_cast<const mrpt::obs::CObservation2DRangeScan&>(**read[i].seen->begin());
    const auto& original =
        dynamic_cast<const mrpt::obs::CObservation2DRangeScan&>(**written[i].seen->begin());
    REQUIRE(scan.getScanSize() == original.getScanSize());
    CHECK(scan.getScanRange(100) == original.getScanRange(100));
  }
  const Map map = loadMap(path);
  CHECK(map.name == path);
  CHECK(map.grid.getRawMap() == mapKeyFrames("", written).grid.getRawMap());
}

TEST_CASE("a file that is no whole simplemap is refused in one line", "[simplemap_file]") {
  const ScratchFolder folder;
  saveKeyFrames({keyFrame({}, {}, {})}, folder.path("whole.simplemap"));
  const std::string bytes = folder.read("whole.simplemap");
  folder.write("cut.simplemap", bytes.substr(0, bytes.size() / 2));
  folder.write("text.simplemap", "hello, this is no simplemap");
  saveKeyFrames({}, folder.path("empty.simplemap"));
  CHECK(contains(errorOf(folder.path("cut.simplemap")), "is damaged"));
  CHECK(contains(errorOf(folder.path("text.simplemap")), "no simplemap at all"));
  CHECK(errorOf(folder.path("empty.simplemap")) ==
        "cannot be made a grid: there are no observations");
  CHECK(errorOf(folder.path("missing.simplemap")) == "no such file");
}

TEST_CASE("a key frame that lacks an observation is refused", "[simplemap_file]") {
  const ScratchFolder folder;
  const KeyFrame key_frame = keyFrame({}, {}, {});
  mrpt::maps::CSimpleMap map;
  map.insert(key_frame.robot_in_map, key_frame.seen);
  folder.write("a.simplemap", withoutObject(serialized(&map), **key_frame.seen->begin()));
  CHECK(errorOf(folder.path("a.simplemap")) ==
        "is damaged: it holds a key frame without pose or observations");
}

TEST_CASE("more key frames than fit into the file are refused unread", "[simplemap_file]") {
  const ScratchFolder folder;
  const mrpt::maps::CSimpleMap map;
  std::string bytes = serialized(&map);
  const size_t count = bytes.size() - 1 - sizeof(std::uint32_t);  // An end mark comes after it.
  REQUIRE(bytes.substr(count, 4) == std::string(4, '\0'));
  bytes.replace(count, 4, "\xFF\xFF\xFF\x0F");
  folder.write("a.simplemap", bytes);
  CHECK(errorOf(folder.path("a.simplemap")) ==
        "is damaged: it claims to hold more key frames than fit into it");
}

TEST_CASE("poses that are no numbers are refused", "[simplemap_file]") {
  const ScratchFolder folder;
  const double value =
      GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  // Written as it is, and then not believed on reading back.
  CHECK_THROWS_AS(saveKeyFrames({keyFrame({}, {}, {value, 0, 0})}, folder.path("a.simplemap")),
                  FileError);
  CHECK(contains(errorOf(folder.path("a.simplemap")), "a key frame whose pose makes no sense"));
}
