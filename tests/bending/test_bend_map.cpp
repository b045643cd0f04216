// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "catch.h"
#include "drawing.h"
#include "sbox/bending/bend_map.h"
#include "sbox/core/state_grid.h"

using namespace sbox;

namespace {

constexpr double kCell = 0.1;

Map office() { return test::drawMap(test::officeWalls(), {}, kCell); }

Displacement constant(double x, double y) {
  return [x, y](const Point2D&) { return Point2D(x, y); };
}

/// Number of cells of `moved` whose centre, less the shift, does not have the value of `map`.
int differing(const Map& map, const Map& moved, const Point2D& shift) {
  int count = 0;
  for (int y = 0; y < moved.height(); ++y) {
    for (int x = 0; x < moved.width(); ++x) {
      const Point2D in_grid =
          inverse(map.corner_in_map).composePoint(moved.cellCentre(x, y) - shift);
      const int column = static_cast<int>(std::floor(in_grid.x / kCell));
      const int row = static_cast<int>(std::floor(in_grid.y / kCell));
      const bool inside = column >= 0 && row >= 0 && column < map.width() && row < map.height();
      const int expected = inside ? map.grid.getRow(row)[column] : 0;
      count += moved.grid.getRow(y)[x] != expected ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("a map that is not displaced stays as it is, cell by cell", "[bending]") {
  const Map map = office();
  const Map bent = bendMap({&map, Pose2D()}, constant(0, 0), 0, {map.corner_in_map, kCell});
  CHECK(bent.width() >= map.width());
  CHECK(differing(map, bent, {0, 0}) == 0);
}

TEST_CASE("whole cells of displacement move the cells as they are", "[bending]") {
  const Map map = office();
  const Map bent = bendMap({&map, Pose2D()}, constant(3 * kCell, -2 * kCell), 4 * kCell,
                           {map.corner_in_map, kCell});
  CHECK(differing(map, bent, {3 * kCell, -2 * kCell}) == 0);
}

TEST_CASE("a bent wall is one line without holes where the displacement puts it", "[bending]") {
  // A wall along x, in free space of either side.
  Map map = makeMap("wall", 200, 60, kCell);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      map.grid.setCell(x, y, y == 30 ? 0.02F : 0.98F);
    }
  }
  const auto lift = [](double x) { return 0.8 * std::sin(x / 5); };
  const Map bent = bendMap(
      {&map, Pose2D()}, [&](const Point2D& p) { return Point2D(0, lift(p.x)); }, 0.8, {{}, kCell});
  for (int x = 0; x < map.width(); ++x) {
    const double place = (x + 0.5) * kCell;
    int walls = 0;
    double where = 0;
    for (int y = 0; y < bent.height(); ++y) {
      const Point2D in_bent = inverse(bent.corner_in_map).composePoint({place, 0});
      if (bent.grid.getCell(static_cast<int>(in_bent.x / kCell), y) < 0.4) {
        ++walls;
        where += bent.cellCentre(0, y).y;
      }
    }
    INFO("at " << place << " m");
    REQUIRE(walls >= 1);
    CHECK(walls <= 2);
    CHECK(where / walls == Approx(3.05 + lift(place)).margin(kCell));
  }
}

TEST_CASE("a bent map beyond the limit is refused before memory is taken", "[bending]") {
  const Map map = office();
  const BentLattice tiny{map.corner_in_map, 1e-5};
  CHECK_THROWS_AS(bendMap({&map, Pose2D()}, constant(0, 0), 0, tiny), std::length_error);
}

TEST_CASE("unknown margins take no cells", "[bending]") {
  const Map map = office();
  constexpr int margin = 300;
  Map padded = makeMap("padded", map.width() + 2 * margin, map.height() + 2 * margin, kCell,
                       {map.corner_in_map.x - margin * kCell, map.corner_in_map.y - margin * kCell,
                        map.corner_in_map.phi});
  for (int y = 0; y < map.height(); ++y) {
    std::copy_n(map.grid.getRow(y), map.width(), padded.grid.getRow(y + margin) + margin);
  }
  const Map bent = bendMap({&padded, Pose2D()}, constant(0, 0), 0, {map.corner_in_map, kCell});
  CHECK(bent.width() <= map.width() + 2);
  CHECK(bent.height() <= map.height() + 2);
  CHECK(differing(map, bent, {0, 0}) == 0);
  const Map nothing = makeMap("nothing", 500, 400, kCell);
  CHECK(bendMap({&nothing, Pose2D()}, constant(0, 0), 0, {{}, kCell}).width() <= 2);
}
