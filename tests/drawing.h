// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Small grids: drawn as text, walls by their ends, or floors as a robot sees them.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
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

/// Walls, and a place in each of the rooms between them.
struct Floor {
  std::vector<Wall> walls;
  std::vector<Point2D> places;
};

/// The walls of the polygon with these corners.
inline std::vector<Wall> wallsRound(const std::vector<Point2D>& corners) {
  std::vector<Wall> walls;
  for (size_t i = 0; i < corners.size(); ++i) {
    walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
  return walls;
}

/// A room with one corner at the origin.
inline Floor roomFloor(double width, double height) {
  return {wallsRound({{0, 0}, {width, 0}, {width, height}, {0, height}}),
          {{width / 2, height / 2}}};
}

/// officeWalls() with its eight rooms.
inline Floor officeFloor() {
  return {officeWalls(),
          {{2, 2}, {7, 2}, {13, 2}, {20, 3}, {3, 11}, {10, 11}, {19, 9.5}, {19, 12.5}}};
}

/// Rooms of all sizes along both sides of a corridor; another floor for each seed.
inline Floor randomFloor(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double length = between(20, 30), corridor = between(4, 7), above = corridor + 2;
  const double top = above + between(4, 7);
  Floor floor{wallsRound({{0, 0}, {length, 0}, {length, top}, {0, top}}),
              {{length / 2, corridor + 1}}};
  floor.walls.push_back({{0, corridor}, {length, corridor}});
  floor.walls.push_back({{0, above}, {length, above}});
  for (const auto& [low, high] : {std::pair(0.0, corridor), std::pair(above, top)}) {
    double x = 0;
    while (x < length) {
      double end = x + between(2.5, 6.5);
      if (end > length - 2.5) {
        end = length;
      }
      floor.walls.push_back({{end, low}, {end, high}});
      floor.places.emplace_back((x + end) / 2, (low + high) / 2);
      x = end;
    }
  }
  return floor;
}

/// A rectangle of the world.
struct Window {
  Point2D low{-1e9, -1e9};
  Point2D high{1e9, 1e9};
};

/// A map as a robot makes it whose map frame has the pose `map_in_world`: what can be reached from
/// the floor's places is free, walls are occupied, all else and what lies outside the window is
/// unknown.
inline Map exploreMap(const Floor& floor, const Pose2D& map_in_world, double resolution,
                      const Window& window = {}) {
  Map map = drawMap(floor.walls, map_in_world, resolution);
  const int width = map.width(), height = map.height();
  std::vector<char> reached(static_cast<size_t>(width) * static_cast<size_t>(height), 0);
  std::vector<std::pair<int, int>> open;
  for (const Point2D& place : floor.places) {
    const Point2D p =
        map.corner_in_map.inverseComposePoint(map_in_world.inverseComposePoint(place));
    open.emplace_back(static_cast<int>(p.x / resolution), static_cast<int>(p.y / resolution));
  }
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    if (x < 0 || y < 0 || x >= width || y >= height || map.grid.getCell(x, y) < 0.5F) {
      continue;
    }
    char& is_reached =
        reached[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    if (is_reached == 0) {
      is_reached = 1;
      open.insert(open.end(), {{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}});
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Point2D p = map_in_world.composePoint(map.cellCentre(x, y));
      const bool is_seen =
          p.x >= window.low.x && p.y >= window.low.y && p.x < window.high.x && p.y < window.high.y;
      const bool is_wall = map.grid.getCell(x, y) < 0.5F;
      const bool is_free =
          reached[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] !=
          0;
      if (!is_seen || (!is_wall && !is_free)) {
        map.grid.setCell(x, y, 0.5F);
      }
    }
  }
  return map;
}

}  // namespace sbox::test
