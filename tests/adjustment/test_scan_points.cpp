// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "mapping/scanned_room.h"
#include "sbox/adjustment/scan_points.h"

using namespace sbox;
using namespace sbox::test;

namespace {

/// From the wall to the inside.
Eigen::Vector2d insideOf(const Room& room, const Eigen::Vector2d& place) {
  const double west = std::abs(place.x() - room.x_min), east = std::abs(place.x() - room.x_max);
  const double south = std::abs(place.y() - room.y_min), north = std::abs(place.y() - room.y_max);
  const double least = std::min({west, east, south, north});
  return least == west    ? Eigen::Vector2d(1, 0)
         : least == east  ? Eigen::Vector2d(-1, 0)
         : least == south ? Eigen::Vector2d(0, 1)
                          : Eigen::Vector2d(0, -1);
}

}  // namespace

TEST_CASE("points of a scan lie on the walls and face the room", "[adjustment]") {
  const Room room;
  const KeyFrame frame = keyFrame(room, {}, {});
  const std::vector<ScanPoint> points = scanPoints(*frame.seen);
  for (const ScanPoint& point : points) {
    CHECK(std::min({std::abs(point.place.x() - room.x_min), std::abs(point.place.x() - room.x_max),
                    std::abs(point.place.y() - room.y_min),
                    std::abs(point.place.y() - room.y_max)}) < 1e-5);
    CHECK(point.normal.norm() == Approx(1));
    CHECK(point.normal.dot(insideOf(room, point.place)) > 0.8);
  }
  const double walls = 2 * (room.x_max - room.x_min + room.y_max - room.y_min);
  CHECK(static_cast<double>(points.size()) > 0.8 * walls / 0.2);
  CHECK(static_cast<double>(points.size()) <= walls / 0.1);
}

TEST_CASE("points are in the robot's frame", "[adjustment]") {
  const Room room;
  const KeyFrame frame = keyFrame(room, {}, {});
  auto& scan = dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(**frame.seen->begin());
  scan.sensorPose = mrpt::poses::CPose3D(0.5, 0, 0.3, M_PI / 2, 0, 0);
  for (const ScanPoint& point : scanPoints(*frame.seen)) {
    // A quarter turn takes (x, y) to (-y, x).
    const Eigen::Vector2d in_room(point.place.y(), 0.5 - point.place.x());
    const Eigen::Vector2d normal(point.normal.y(), -point.normal.x());
    CHECK(normal.dot(insideOf(room, in_room)) > 0.8);
  }
}

TEST_CASE("far points and tilted lidars are left out", "[adjustment]") {
  const KeyFrame frame = keyFrame({}, {}, {});
  ScanPointOptions options;
  options.max_range = 2.5;
  const std::vector<ScanPoint> near = scanPoints(*frame.seen, options);
  CHECK_FALSE(near.empty());
  CHECK(near.size() < scanPoints(*frame.seen).size());
  CHECK(std::all_of(near.begin(), near.end(),
                    [](const ScanPoint& point) { return point.place.norm() <= 2.5; }));
  auto& scan = dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(**frame.seen->begin());
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0, 0.1, 0);
  CHECK(scanPoints(*frame.seen).empty());
  CHECK(scanPoints({}).empty());
}

TEST_CASE("a scan of one beam has no surface", "[adjustment]") {
  const KeyFrame frame = keyFrame({}, {}, {});
  auto& scan = dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(**frame.seen->begin());
  scan.resizeScan(1);
  CHECK(scanPoints(*frame.seen).empty());
}
