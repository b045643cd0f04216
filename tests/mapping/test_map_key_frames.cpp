// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationRange.h>

#include <cmath>
#include <limits>
#include <memory>

#include "catch.h"
#include "mapping/scanned_room.h"
#include "sbox/core/state_grid.h"
#include "sbox/mapping/map_key_frames.h"

using namespace sbox;
using namespace sbox::test;

TEST_CASE("a scanned room has its walls where they are", "[map_key_frames]") {
  const auto [corner, cell] = GENERATE(table<Pose2D, double>(
      {{{0, 0, 0}, 0.05}, {{100, -250, 0}, 0.05}, {{7, 3, 0.6}, 0.05}, {{0, 0, 0}, 0.1}}));
  const Room room;
  KeyFrames frames;
  for (const Pose2D& robot : {Pose2D(0, 0, 0), Pose2D(1, 0.5, 1), Pose2D(-1, 0.3, -2)}) {
    frames.push_back(keyFrame(room, robot, corner + robot));
  }
  MappingOptions options;
  options.resolution = cell;
  const Map map = mapKeyFrames("room", frames, options);
  CHECK(map.name == "room");
  CHECK(map.resolution() == Approx(cell));
  const StateGrid states = classifyCells(map);
  int free = 0, leaked = 0, occupied = 0, off_wall = 0;
  for (int y = 0; y < states.height; ++y) {
    for (int x = 0; x < states.width; ++x) {
      const Point2D p = corner.inverseComposePoint(
          states.corner_in_map.composePoint({(x + 0.5) * cell, (y + 0.5) * cell}));
      const double inside =
          std::min({p.x - room.x_min, room.x_max - p.x, p.y - room.y_min, room.y_max - p.y});
      const CellState state = states.at(x, y);
      free += state == CellState::Free ? 1 : 0;
      leaked += state == CellState::Free && inside < -cell ? 1 : 0;
      occupied += state == CellState::Occupied ? 1 : 0;
      off_wall += state == CellState::Occupied && std::abs(inside) > 1.5 * cell ? 1 : 0;
    }
  }
  CHECK(off_wall == 0);
  CHECK(leaked < free / 100);  // MRPT widens beams, also past a wall seen at a flat angle
  const double wall_cells = 2 * (5.04 + 3.04) / cell;
  CHECK(occupied > 0.8 * wall_cells);
  CHECK(occupied < 2 * wall_cells);
  CHECK(free * cell * cell == Approx(5.04 * 3.04).epsilon(0.1));
}

TEST_CASE("a tilted lidar is left out, a level one upside down is not", "[map_key_frames]") {
  const Room room;
  KeyFrames frames{keyFrame(room, {}, {})};
  auto& scan = dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(**frames[0].seen->begin());
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 0.4, 0, 0, M_PI);
  CHECK_NOTHROW(mapKeyFrames("upside down", frames));
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 0.4, 0, 0.03, 0);
  CHECK_NOTHROW(mapKeyFrames("nearly level", frames));
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 0.4, 0, 0.1, 0);
  CHECK_THROWS_WITH(mapKeyFrames("tilted", frames), "no observation is a level 2D scan");
}

TEST_CASE("what cannot be mapped is refused before memory is taken", "[map_key_frames]") {
  CHECK_THROWS_AS(mapKeyFrames("nothing", {}), std::invalid_argument);
  const Room room;
  const KeyFrames far_apart{keyFrame(room, {}, {}), keyFrame(room, {}, {1e6, 1e6, 0})};
  CHECK_THROWS_AS(mapKeyFrames("far apart", far_apart), std::length_error);
  const KeyFrames far_away{keyFrame(room, {}, {1e9, 0, 0})};
  CHECK_THROWS_AS(mapKeyFrames("far away", far_away), std::length_error);
  MappingOptions options;
  options.certainty = 0.5;
  CHECK_THROWS_AS(mapKeyFrames("room", {keyFrame(room, {}, {})}, options), std::invalid_argument);
}

TEST_CASE("scans that cannot be are refused", "[map_key_frames]") {
  const Room room;
  // The first is sound, so that the extent of the map is.
  KeyFrames frames{keyFrame(room, {}, {}), keyFrame(room, {}, {})};
  auto& scan = dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(**frames[1].seen->begin());
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  SECTION("a sensor without a heading") { scan.sensorPose = {0, 0, 0, none, 0, 0}; }
  SECTION("a sensor without a place") { scan.sensorPose = {none, 0, 0, 0, 0, 0}; }
  SECTION("a range below zero") { scan.setScanRange(100, -1e30F); }
  SECTION("no aperture") { scan.aperture = none; }
  SECTION("an aperture of many turns") { scan.aperture = 1e30F; }
  SECTION("a sonar that measures below zero") {
    const auto sonar = std::make_shared<mrpt::obs::CObservationRange>();
    sonar->sensedData.resize(1);
    sonar->sensedData[0].sensedDistance = -1;
    frames[1].seen->insert(sonar);
  }
  CHECK_THROWS_WITH(mapKeyFrames("room", frames),
                    "the pose, angles or ranges of a scan make no sense");
}

TEST_CASE("beams without an echo are no fault of a scan", "[map_key_frames]") {
  const Room room;
  const KeyFrames frames{keyFrame(room, {}, {})};
  auto& scan = dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(**frames[0].seen->begin());
  scan.setScanRange(100, std::numeric_limits<float>::infinity());
  scan.setScanRange(200, std::numeric_limits<float>::quiet_NaN());
  CHECK(mapKeyFrames("room", frames).width() > 100);
}
