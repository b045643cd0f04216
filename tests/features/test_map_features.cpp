// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/features/map_features.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

constexpr double kWidth = 6, kHeight = 4;

/// Distance from p to the nearest of the points.
double nearest(const std::vector<Point2D>& points, const Point2D& p) {
  double least = 1e9;
  for (const Point2D& q : points) {
    least = std::min(least, std::hypot(q.x - p.x, q.y - p.y));
  }
  return least;
}

/// That the features are the four walls, the four corners and the box of the room, in a map frame
/// that lies in the room's at `map_in_world`.
void checkRoom(const MapFeatures& features, const Pose2D& map_in_world, double tolerance) {
  const FeatureSet& set = features.feature_set;
  REQUIRE(features.frames.size() == 1);
  for (const std::vector<AxisLine>& side : features.frames[0].lines) {
    CHECK(side.size() == 1);
  }
  CHECK(set.vertical_points.size() == 4);
  REQUIRE(set.boxes.size() == 1);
  const std::vector<Point2D> box(set.boxes[0].begin(), set.boxes[0].end());
  for (const Point2D& corner :
       {Point2D(0, 0), Point2D(kWidth, 0), Point2D(kWidth, kHeight), Point2D(0, kHeight)}) {
    const Point2D expected = map_in_world.inverseComposePoint(corner);
    CHECK(nearest(set.vertical_points, expected) < tolerance);
    CHECK(nearest(box, expected) < tolerance);
  }
  const WallBox& of_frame = features.frames[0].boxes[0];
  CHECK(of_frame.facing_in == 0xF);
  CHECK(std::max(of_frame.size_x, of_frame.size_y) == Approx(kWidth).margin(0.2));
  CHECK(std::min(of_frame.size_x, of_frame.size_y) == Approx(kHeight).margin(0.2));
}

std::vector<std::pair<double, double>> sorted(const std::vector<Vector2d>& points) {
  std::vector<std::pair<double, double>> result;
  for (const Vector2d& p : points) {
    result.emplace_back(p.x(), p.y());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

TEST_CASE("a room's features are its walls, corners and box, whatever its frame", "[features]") {
  for (const double resolution : {0.05, 0.1}) {
    for (const Pose2D& map_in_world :
         {Pose2D(0, 0, 0), Pose2D(-7, 12, 0), Pose2D(0, 0, 0.4), Pose2D(-7, 12, -2.3)}) {
      INFO(map_in_world << ", cells of " << resolution << " m");
      checkRoom(extractFeatures(
                    test::exploreMap(test::roomFloor(kWidth, kHeight), map_in_world, resolution)),
                map_in_world, 0.2);
    }
  }
}

TEST_CASE("turning and shifting the rows in the map frame moves the features with them",
          "[features]") {
  Map map = test::exploreMap(test::roomFloor(kWidth, kHeight), {}, 0.1);
  const MapFeatures plain = extractFeatures(map);
  for (const Pose2D& moved : {Pose2D(5, -3, 0), Pose2D(0, 0, 1.1), Pose2D(5, -3, -2.7)}) {
    Map other = map;
    other.corner_in_map = moved + map.corner_in_map;
    const MapFeatures features = extractFeatures(other);
    checkRoom(features, inverse(moved), 0.2);
    // All that is in the grid frame stays.
    CHECK(features.digest == plain.digest);
    CHECK(features.wall_points.size() == plain.wall_points.size());
    CHECK(features.frames[0].frame.direction == plain.frames[0].frame.direction);
    CHECK(features.fields.distances == plain.fields.distances);
  }
}

TEST_CASE("unknown margins change nothing", "[features]") {
  const Map map = test::exploreMap(test::roomFloor(kWidth, kHeight), {}, 0.1);
  Map wide = makeMap("wide", map.width() + 37, map.height() + 11, 0.1,
                     map.corner_in_map + Pose2D(-2.1, -0.4, 0));
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      wide.grid.setCell(x + 21, y + 4, map.grid.getCell(x, y));
    }
  }
  const MapFeatures features = extractFeatures(map), of_wide = extractFeatures(wide);
  CHECK(of_wide.digest == features.digest);
  CHECK(of_wide.width == features.width);
  CHECK(of_wide.fields.distances == features.fields.distances);
  CHECK(of_wide.grid_in_map.x == Approx(features.grid_in_map.x).margin(1e-6));
  CHECK(of_wide.grid_in_map.y == Approx(features.grid_in_map.y).margin(1e-6));
}

TEST_CASE("wall points and free points are scattered, none lost", "[features]") {
  const Map map = test::exploreMap(test::officeFloor(), {}, 0.1);
  const MapFeatures features = extractFeatures(map);
  const StateGrid grid = classifyCells(map);
  std::vector<Vector2d> in_order, scattered;
  for (const WallPoint& point : findWalls(traceFreeContours(grid), grid.resolution).points) {
    in_order.push_back(point.position);
  }
  for (const WallPoint& point : features.wall_points) {
    scattered.push_back(point.position);
  }
  CHECK((sorted(scattered) == sorted(in_order)));
  REQUIRE(features.wall_directions.size() == features.wall_points.size());
  for (size_t i = 0; i < features.wall_points.size(); ++i) {
    const Vector2d& normal = features.wall_points[i].normal;
    CHECK(features.wall_directions[i] == toByteAngle(std::atan2(normal.y(), normal.x())));
  }
  // The first tenth has about a tenth of the points of each quarter of the floor.
  const auto quarter = [&](const Vector2d& p) {
    return (p.x() > features.width / 2 ? 1U : 0U) + (p.y() > features.height / 2 ? 2U : 0U);
  };
  for (const std::vector<Vector2d>& points : {scattered, features.free_points}) {
    std::array<double, 4> all{}, first{};
    for (size_t i = 0; i < points.size(); ++i) {
      all[quarter(points[i])] += 1;
      first[quarter(points[i])] += 10 * i < points.size() ? 1 : 0;
    }
    for (size_t q = 0; q < 4; ++q) {
      CHECK(first[q] == Approx(all[q] / 10).epsilon(0.2));
    }
  }
  // Free points stand for all of the free space.
  double free_cells = 0;
  for (const CellState cell : grid.cells) {
    free_cells += cell == CellState::Free ? 1 : 0;
  }
  CHECK(features.free_point_area * static_cast<double>(features.free_points.size()) ==
        Approx(free_cells * 0.01).epsilon(0.05));
  for (const Vector2d& p : features.free_points) {
    CHECK(grid.at(static_cast<int>(p.x() / 0.1), static_cast<int>(p.y() / 0.1)) == CellState::Free);
  }
}

TEST_CASE("of too many wall and free points those kept stand for all", "[features]") {
  // Corridors a cell wide, with a wall on either side: 24 km of wall.
  constexpr int size = 602;
  constexpr double cell = 0.1;
  Map comb = makeMap("comb", size, size, cell);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      comb.grid.setCell(x, y, y % 3 == 1 && x > 0 && x < size - 1 ? 1.0F : 0.0F);
    }
  }
  FeatureOptions options;
  options.free_spacing = cell;
  options.most_free_points = 9000;
  const MapFeatures features = extractFeatures(comb, options);
  CHECK(features.wall_points.size() == WallFields::most_points);
  constexpr double corridors = 1 + (size - 2) / 3.0, length = (size - 2) * cell;
  CHECK(features.wallLength() == Approx(2 * corridors * length).epsilon(0.01));
  CHECK(features.free_points.size() < 9000);
  CHECK(features.freeArea() == Approx(corridors * length * cell).epsilon(0.1));
  double middle = 0;
  for (const WallPoint& point : features.wall_points) {
    middle += point.position.y() / static_cast<double>(features.wall_points.size());
  }
  CHECK(middle == Approx(features.height / 2).epsilon(0.01));
  const MapFeatures office = extractFeatures(test::exploreMap(test::officeFloor(), {}, 0.1));
  CHECK(office.point_spacing == WallLineOptions().point_spacing);
  CHECK(office.free_point_area == FeatureOptions().free_spacing * FeatureOptions().free_spacing);
}

TEST_CASE("boxes and vertical points are listed frame by frame", "[features]") {
  // A square hall and a hall at 30 degrees: two frames.
  test::Floor floor = test::roomFloor(8, 8);
  const Pose2D wing(12, 1, M_PI / 6);
  const test::Floor turned = test::roomFloor(7, 5);
  for (const test::Wall& wall : turned.walls) {
    floor.walls.push_back({wing.composePoint(wall.from), wing.composePoint(wall.to)});
  }
  floor.places.push_back(wing.composePoint(turned.places[0]));
  const MapFeatures features = extractFeatures(test::exploreMap(floor, {}, 0.1));
  REQUIRE(features.frames.size() == 2);
  size_t boxes = 0, corners = 0;
  for (const FrameFeatures& frame : features.frames) {
    boxes += frame.boxes.size();
    corners += frame.corners.size();
  }
  CHECK(features.feature_set.boxes.size() == boxes);
  CHECK(features.feature_set.vertical_points.size() == corners);
  const FrameFeatures& first = features.frames[0];
  REQUIRE(!first.boxes.empty());
  const Vector2d in_grid = Eigen::Rotation2Dd(first.frame.direction) * first.boxes[0].corners[0];
  const Point2D in_map = features.grid_in_map.composePoint({in_grid.x(), in_grid.y()});
  CHECK(features.feature_set.boxes[0][0].x == Approx(in_map.x));
  CHECK(features.feature_set.boxes[0][0].y == Approx(in_map.y));
}

TEST_CASE("other cells have another digest", "[features]") {
  const test::Floor floor = test::roomFloor(kWidth, kHeight);
  Map map = test::exploreMap(floor, {}, 0.1);
  const std::uint64_t digest = extractFeatures(map).digest;
  CHECK(extractFeatures(test::exploreMap(floor, {}, 0.1)).digest == digest);
  map.grid.setCell(map.width() / 2, map.height() / 2, 0.0F);
  CHECK(extractFeatures(map).digest != digest);
}

TEST_CASE("maps that differ in their own cells only have an order, too", "[features]") {
  const auto room = [](int thickness) {
    Map map = makeMap("room", 100, 80, 0.05);
    map.grid.fill(0.95F);
    for (int y = 0; y < 80; ++y) {
      for (int x = 0; x < 100; ++x) {
        if (x == 0 || y == 0 || y == 79 || x >= 100 - thickness) {
          map.grid.setCell(x, y, 0.05F);
        }
      }
    }
    return extractFeatures(map);
  };
  const MapFeatures one = room(1), other = room(2);
  REQUIRE(one.digest == other.digest);
  CHECK(comesFirst(one, other) != comesFirst(other, one));
  CHECK_FALSE(comesFirst(one, room(1)));
}

TEST_CASE("a map without walls has no features", "[features]") {
  const MapFeatures unknown = extractFeatures(makeMap("unknown", 50, 40, 0.05));
  CHECK(unknown.empty());
  CHECK(unknown.frames.empty());
  Map free = makeMap("free", 50, 40, 0.1);
  Map occupied = free;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 50; ++x) {
      free.grid.setCell(x, y, 1.0F);
      occupied.grid.setCell(x, y, 0.0F);
    }
  }
  CHECK(extractFeatures(free).empty());
  CHECK(extractFeatures(occupied).empty());
  Map speck = makeMap("speck", 1, 1, 0.05);
  speck.grid.setCell(0, 0, 1.0F);
  CHECK(extractFeatures(speck).empty());
}

TEST_CASE("the first wall points share all wall between them", "[features]") {
  MapFeatures features;
  features.wall_points.resize(60);
  features.point_spacing = 0.2;
  CHECK(features.wallLengthPerPoint(60) == Approx(0.2));
  CHECK(features.wallLengthPerPoint(15) == Approx(0.8));
  CHECK(MapFeatures().wallLengthPerPoint(0) == 0);
}
