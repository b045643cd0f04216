// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "sbox-dataset/drive.h"
#include "sbox/core/state_grid.h"

using namespace sbox;
using namespace sbox::dataset;

TEST_CASE("a mapped room has its walls where they are", "[run]") {
  World world;
  world.walls = {{{-2, -1}, {3, -1}}, {{3, -1}, {3, 2}}, {{3, 2}, {-2, 2}}, {{-2, 2}, {-2, -1}}};
  DriveOptions noiseless;
  noiseless.range_sigma = noiseless.odometry_sigma = noiseless.heading_sigma = 0;
  noiseless.field_of_view = 2 * M_PI;
  const Run run = drive(world, {{0, 0, 0}, {{1, 0.5}, {-1, 0.5}}}, noiseless);
  const Map map = mapRun("room", run);
  CHECK(map.name == "room");
  // The walls' own cells, and beams that widen with the distance, reach a little further.
  CHECK(map.width() == Approx(5 / 0.05).margin(5));
  CHECK(map.height() == Approx(3 / 0.05).margin(5));
  const StateGrid states = classifyCells(map);
  const auto stateAt = [&](double x, double y) {
    const Point2D p = states.corner_in_map.inverseComposePoint(Point2D(x, y));
    return states.at(static_cast<int>(p.x / 0.05), static_cast<int>(p.y / 0.05));
  };
  CHECK(stateAt(0.01, 0.01) == CellState::Free);
  CHECK(stateAt(2.5, 1.5) == CellState::Free);
  int occupied_near_wall = 0, occupied = 0;
  for (int y = 0; y < states.height; ++y) {
    for (int x = 0; x < states.width; ++x) {
      if (states.at(x, y) != CellState::Occupied) {
        continue;
      }
      const Point2D p = states.corner_in_map.composePoint({(x + 0.5) * 0.05, (y + 0.5) * 0.05});
      const double off =
          std::min({std::abs(p.x + 2), std::abs(p.x - 3), std::abs(p.y + 1), std::abs(p.y - 2)});
      ++occupied;
      occupied_near_wall += off < 0.08 ? 1 : 0;
    }
  }
  CHECK(occupied > 250);
  CHECK(occupied_near_wall == occupied);
}
