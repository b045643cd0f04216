// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Small grids for the tests of the published method: drawn as text, or walls by their ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sbox/core/state_grid.h"

namespace sbox::test {

/// '#' occupied, '.' free, ' ' unknown; the first row is the highest. Rows of equal length.
inline StateGrid gridFromText(const std::vector<std::string>& rows, double resolution) {
  StateGrid grid;
  grid.width = static_cast<int>(rows.front().size());
  grid.height = static_cast<int>(rows.size());
  grid.resolution = resolution;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      grid.cells.push_back(c == '#'   ? CellState::Occupied
                           : c == '.' ? CellState::Free
                                      : CellState::Unknown);
    }
  }
  return grid;
}

inline StateGrid freeGrid(int width, int height, double resolution) {
  StateGrid grid;
  grid.width = width;
  grid.height = height;
  grid.resolution = resolution;
  grid.cells.assign(static_cast<size_t>(width) * static_cast<size_t>(height), CellState::Free);
  return grid;
}

struct Wall {
  Point2D from;
  Point2D to;
};

/// Marks the cells under a wall, given in the grid frame, as occupied.
inline void drawWall(StateGrid& grid, const Wall& wall) {
  const Point2D way = wall.to - wall.from;
  const int steps = static_cast<int>(std::ceil(4 * std::hypot(way.x, way.y) / grid.resolution)) + 1;
  for (int i = 0; i <= steps; ++i) {
    const Point2D p = wall.from + way * (1.0 * i / steps);
    const int x = static_cast<int>(std::floor(p.x / grid.resolution));
    const int y = static_cast<int>(std::floor(p.y / grid.resolution));
    if (x >= 0 && y >= 0 && x < grid.width && y < grid.height) {
      grid.cells[static_cast<size_t>(y) * static_cast<size_t>(grid.width) +
                 static_cast<size_t>(x)] = CellState::Occupied;
    }
  }
}

/// An office floor of 24 m x 14 m without any symmetry.
inline std::vector<Wall> officeWalls() {
  return {{{0, 0}, {24, 0}},  {{24, 0}, {24, 14}}, {{24, 14}, {0, 14}}, {{0, 14}, {0, 0}},
          {{0, 5}, {17, 5}},  {{0, 8}, {24, 8}},   {{4, 0}, {4, 5}},    {{9.5, 0}, {9.5, 5}},
          {{17, 0}, {17, 5}}, {{6, 8}, {6, 14}},   {{14, 8}, {14, 14}}, {{14, 11}, {24, 11}}};
}

/// A map of the walls as a robot would draw it whose map frame has the pose `map_in_world`.
inline Map drawMap(const std::vector<Wall>& walls, const Pose2D& map_in_world, double resolution) {
  std::vector<Wall> drawn;
  Point2D low(1e9, 1e9), high(-1e9, -1e9);
  for (const Wall& wall : walls) {
    const Wall w{map_in_world.inverseComposePoint(wall.from),
                 map_in_world.inverseComposePoint(wall.to)};
    low = {std::min({low.x, w.from.x, w.to.x}), std::min({low.y, w.from.y, w.to.y})};
    high = {std::max({high.x, w.from.x, w.to.x}), std::max({high.y, w.from.y, w.to.y})};
    drawn.push_back(w);
  }
  const Point2D corner = low - Point2D(1, 1);
  StateGrid grid = freeGrid(static_cast<int>((high.x - low.x + 2) / resolution),
                            static_cast<int>((high.y - low.y + 2) / resolution), resolution);
  for (const Wall& w : drawn) {
    drawWall(grid, {w.from - corner, w.to - corner});
  }
  Map map = makeMap("drawn", grid.width, grid.height, resolution, {corner.x, corner.y, 0});
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      map.grid.setCell(x, y, grid.at(x, y) == CellState::Occupied ? 0.0F : 1.0F);
    }
  }
  return map;
}

}  // namespace sbox::test
