// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-scale/building.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace sbox::scale {
namespace {

constexpr std::int8_t wall = -80, open = 80;
constexpr int wall_cells = 3, corridor_cells = 45, door_cells = 20;

}  // namespace

Building::Building(int side, unsigned seed)
    : side_(side), cells_(static_cast<size_t>(side) * static_cast<size_t>(side), open) {
  std::mt19937 random(seed);
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
  };
  // From below: a row of rooms, a wall with doors, a corridor, a wall with doors, a row of rooms,
  // an outer wall, and so on.
  for (int y = 0; y < side;) {
    for (const bool rooms_above : {false, true}) {
      const int depth = between(80, 160), y0 = y, y1 = y + depth;
      const int door_wall = rooms_above ? y0 : y1;
      fill(0, door_wall, side, door_wall + wall_cells, wall);
      for (int x = 0; x < side;) {
        const int width = between(60, 180);
        fill(x, y0, x + wall_cells, y1, wall);
        const int door = x + between(wall_cells + 4, width - door_cells - 4);
        fill(door, door_wall, door + door_cells, door_wall + wall_cells, open);
        x += width;
      }
      y = y1 + (rooms_above ? 0 : corridor_cells);
    }
    fill(0, y, side, y + wall_cells, wall);
    // A way through to the next rooms.
    const int door = between(0, side - door_cells);
    fill(door, y, door + door_cells, y + wall_cells, open);
    y += wall_cells;
  }
}

void Building::fill(int x0, int y0, int x1, int y1, std::int8_t value) {
  for (int y = std::max(y0, 0); y < std::min(y1, side_); ++y) {
    std::int8_t* row = cells_.data() + static_cast<size_t>(y) * static_cast<size_t>(side_);
    for (int x = std::max(x0, 0); x < std::min(x1, side_); ++x) {
      row[x] = value;
    }
  }
}

Map Building::mapAt(const std::string& name, const Pose2D& pose_in_building, int side,
                    double radius) const {
  Map map = makeMap(name, side, side, cell_size);
  const double c = std::cos(pose_in_building.phi), s = std::sin(pose_in_building.phi);
  const double middle = side * cell_size / 2;
  for (int y = 0; y < side; ++y) {
    auto* row = map.grid.getRow(y);
    for (int x = 0; x < side; ++x) {
      const double mx = (x + 0.5) * cell_size, my = (y + 0.5) * cell_size;
      const auto bx =
          static_cast<int>(std::floor((pose_in_building.x + c * mx - s * my) / cell_size));
      const auto by =
          static_cast<int>(std::floor((pose_in_building.y + s * mx + c * my) / cell_size));
      const double dx = mx - middle, dy = my - middle;
      if (bx >= 0 && by >= 0 && bx < side_ && by < side_ && dx * dx + dy * dy <= radius * radius) {
        row[x] =
            cells_[static_cast<size_t>(by) * static_cast<size_t>(side_) + static_cast<size_t>(bx)];
      }
    }
  }
  return map;
}

}  // namespace sbox::scale
