// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "sbox-dataset/office.h"
#include "sbox-dataset/ranger.h"
#include "sbox-dataset/world_grid.h"

using namespace sbox;
using namespace sbox::dataset;

TEST_CASE("every cell that a wall touches is occupied, and no other", "[world grid]") {
  World world;
  world.walls = {{{0.05, 0.05}, {0.85, 0.45}}, {{0.85, 0.45}, {0.85, 0.95}}};
  const auto grid = worldGrid(world, 0.1, 0.25);
  for (unsigned y = 0; y < grid.getSizeY(); ++y) {
    for (unsigned x = 0; x < grid.getSizeX(); ++x) {
      const double left = grid.idx2x(static_cast<int>(x)) - 0.05,
                   low = grid.idx2y(static_cast<int>(y)) - 0.05;
      // By brute force: points along the walls, close together.
      bool touched = false, on_border = false;
      for (const LineSegment& wall : world.walls) {
        for (int i = 0; i <= 2000; ++i) {
          const Point2D p = wall.from + (wall.to - wall.from) * (i / 2000.0);
          const double u = p.x - left, v = p.y - low;
          touched = touched || (u > 1e-4 && u < 0.1 - 1e-4 && v > 1e-4 && v < 0.1 - 1e-4);
          on_border = on_border || (u > -1e-4 && u < 0.1 + 1e-4 && v > -1e-4 && v < 0.1 + 1e-4);
        }
      }
      INFO(x << " " << y);
      const bool occupied = grid.getCell(static_cast<int>(x), static_cast<int>(y)) < 0.5F;
      if (touched || !on_border) {
        CHECK(occupied == touched);
      }
    }
  }
}

TEST_CASE("MRPT's scan simulator agrees with the exact ranges", "[ranger]") {
  const World office = randomOffice(4);
  const auto grid = worldGrid(office, 0.02);
  mrpt::obs::CObservation2DRangeScan exact;
  exact.aperture = 4.7F;
  exact.maxRange = 8;
  exact.rightToLeft = true;
  exact.resizeScan(361);
  auto simulated = exact;
  size_t compared = 0, near = 0;
  for (const Point2D& place : office.places) {
    exactRanger(office)({place.x, place.y, 0.3}, exact);
    gridRanger(grid)({place.x, place.y, 0.3}, simulated);
    REQUIRE(simulated.getScanSize() == exact.getScanSize());
    for (size_t i = 0; i < exact.getScanSize(); ++i) {
      if (exact.getScanRangeValidity(i) && simulated.getScanRangeValidity(i)) {
        ++compared;
        near += std::abs(exact.getScanRange(i) - simulated.getScanRange(i)) < 0.06F ? 1 : 0;
      }
    }
  }
  CHECK(compared > 1000);
  // Beams that graze a wall's end or run along a wall differ by more.
  CHECK(static_cast<double>(near) > 0.97 * static_cast<double>(compared));
}
