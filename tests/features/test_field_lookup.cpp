// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

#include "catch.h"
#include "sbox/features/field_lookup.h"
#include "scattered_map.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

/// Places on the fields of a map of 8 m x 6 m and beside them, on all edges, and nowhere.
std::vector<Vector2d> places(const WallFields& fields) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(-3, 11), y(-3, 9);
  std::vector<Vector2d> places;
  for (int i = 0; i < 1000; ++i) {
    places.emplace_back(x(random), y(random));
  }
  const Vector2d low = fields.origin;
  const Vector2d high = low + Vector2d(fields.width, fields.height) * fields.resolution;
  for (const double nudge : {-1e-9, 0.0, 1e-9}) {
    places.emplace_back(low.x() + nudge, 1);
    places.emplace_back(1, low.y() + nudge);
    places.emplace_back(high.x() + nudge, 1);
    places.emplace_back(1, high.y() + nudge);
  }
  places.emplace_back(std::numeric_limits<double>::quiet_NaN(), 1);
  places.emplace_back(1, std::numeric_limits<double>::infinity());
  places.emplace_back(-1e18, 1e18);
  return places;
}

/// As `addresses_of`: nothing of the fields is read.
constexpr auto kNothingRead = [](size_t, size_t) { return std::array<const void*, 0>(); };

}  // namespace

TEST_CASE("many points find their cells, walls and depths as one by one", "[features]") {
  const MapFeatures map = test::scatteredMap(1).features;
  const WallFields& fields = map.fields;
  const std::vector<Vector2d> points = places(fields);
  const auto placeOf = [&](size_t i) { return points[i]; };
  const auto directionOf = [&](size_t i) { return static_cast<ByteAngle>(37 * i); };

  std::vector<std::tuple<size_t, size_t>> cells, cells_found;
  std::vector<std::tuple<size_t, int, int>> values, values_found;
  std::vector<std::tuple<size_t, int>> depths, depths_found;
  std::vector<std::tuple<size_t, double, const WallPoint*>> walls, walls_found;
  for (size_t i = 0; i < points.size(); ++i) {
    const std::ptrdiff_t cell = fields.cellAt(points[i].x(), points[i].y());
    if (cell < 0) {
      continue;
    }
    const auto k = static_cast<size_t>(cell);
    const size_t sector = sectorOf(directionOf(i));
    cells.emplace_back(i, k);
    values.emplace_back(i, fields.distances[sector][k], fields.free_depth[k]);
    depths.emplace_back(i, fields.free_depth[k]);
    if (fields.nearest[sector][k] != WallFields::none) {
      walls.emplace_back(i, points[i].x(),
                         &map.wall_points[static_cast<size_t>(fields.nearest[sector][k])]);
    }
  }
  forEachCell(fields, points.size(), placeOf, kNothingRead,
              [&](size_t i, const Vector2d&, size_t cell) { cells_found.emplace_back(i, cell); });
  forEachField(fields, points.size(), placeOf, directionOf, [&](size_t i, int distance, int depth) {
    values_found.emplace_back(i, distance, depth);
  });
  forEachDepth(fields, points.size(), placeOf,
               [&](size_t i, int depth) { depths_found.emplace_back(i, depth); });
  forEachNearest(fields, map.wall_points, points.size(), placeOf, directionOf,
                 [&](size_t i, const Vector2d& place, const WallPoint& nearest) {
                   walls_found.emplace_back(i, place.x(), &nearest);
                 });
  CHECK(cells.size() > 400);
  CHECK(cells.size() < points.size() - 200);
  CHECK(walls.size() > 100);
  CHECK(walls.size() < cells.size() - 100);
  CHECK(cells_found == cells);
  CHECK(values_found == values);
  CHECK(depths_found == depths);
  CHECK(walls_found == walls);
}

TEST_CASE("fields of nothing hold no point", "[features]") {
  const WallFields none = makeFields(StateGrid(), {});
  int found = 0;
  forEachCell(
      none, 3, [](size_t) { return Vector2d(0, 0); }, kNothingRead,
      [&](size_t, const Vector2d&, size_t) { ++found; });
  CHECK(found == 0);
}
