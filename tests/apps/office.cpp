// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/office.h"

#include <cmath>
#include <random>

namespace sbox::test {
namespace {

constexpr int width = 480;
constexpr int height = 320;
constexpr float wall = 0.05F;
constexpr float open = 0.95F;

void fill(Map& map, int x0, int y0, int x1, int y1, float p_free) {
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      map.grid.setCell(x, y, p_free);
    }
  }
}

/// Rooms along the corridor between the rows y0 and y1, each with a door to the row `door_y`.
void addRooms(Map& map, std::mt19937& random, int y0, int y1, int door_y) {
  int x = 10;
  while (x < width - 90) {
    const int room = 50 + static_cast<int>(random() % 60);
    const int end = x + room < width - 70 ? x + room : width - 10;
    fill(map, end - 2, y0, end, y1, wall);
    const int door = x + 8 + static_cast<int>(random() % 16);
    fill(map, door, door_y, door + 18, door_y + 2, open);
    x = end;
  }
}

}  // namespace

Map office(const std::string& name, unsigned number) {
  std::mt19937 random(number);
  Map map = makeMap(name, width, height, 0.05);
  const int corridor = 120 + static_cast<int>(random() % 60);
  fill(map, 8, 8, width - 8, height - 8, wall);
  fill(map, 10, 10, width - 10, height - 10, open);
  fill(map, 10, corridor, width - 10, corridor + 2, wall);
  fill(map, 10, corridor + 40, width - 10, corridor + 42, wall);
  addRooms(map, random, 10, corridor, corridor);
  addRooms(map, random, corridor + 42, height - 10, corridor + 40);
  return map;
}

Map roundHall(const std::string& name) {
  constexpr int size = 220;
  constexpr double radius = 100;
  Map map = makeMap(name, size, size, 0.05);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double from_middle = std::hypot(x - size / 2, y - size / 2);
      if (from_middle < radius) {
        map.grid.setCell(x, y, from_middle < radius - 2 ? open : wall);
      }
    }
  }
  return map;
}

Map cutColumns(const Map& map, const std::string& name, int first, int last,
               const Pose2D& corner_in_map) {
  Map cut = makeMap(name, last - first, map.height(), map.resolution(), corner_in_map);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = first; x < last; ++x) {
      cut.grid.setCell(x - first, y, map.grid.getCell(x, y));
    }
  }
  return cut;
}

}  // namespace sbox::test
