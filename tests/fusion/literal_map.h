// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps written as text, and back: '#' occupied, '.' free, ' ' unknown; the first line is the top
// row.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/map.h"

namespace sbox::test {

inline constexpr int kOccupied = -100, kFree = 80;

inline void setCell(Map* map, int x, int y, int log_odds) {
  map->grid.getRow(y)[x] = static_cast<mrpt::maps::COccupancyGridMap2D::cellType>(log_odds);
}

inline int cellAt(const Map& map, int x, int y) {
  return x < 0 || y < 0 || x >= map.width() || y >= map.height() ? 0 : map.grid.getRow(y)[x];
}

inline Map literalMap(const std::vector<std::string>& rows, double resolution = 0.1,
                      const Pose2D& corner_in_map = {}) {
  const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows[0].size());
  Map map = makeMap("literal", width, height, resolution, corner_in_map);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const char c = rows[static_cast<size_t>(height - 1 - y)][static_cast<size_t>(x)];
      setCell(&map, x, y, c == '#' ? kOccupied : c == '.' ? kFree : 0);
    }
  }
  return map;
}

inline std::vector<std::string> asText(const Map& map) {
  std::vector<std::string> rows;
  for (int y = map.height() - 1; y >= 0; --y) {
    std::string row;
    for (int x = 0; x < map.width(); ++x) {
      const int value = cellAt(map, x, y);
      row += value < 0 ? '#' : value > 0 ? '.' : ' ';
    }
    rows.push_back(row);
  }
  return rows;
}

inline bool sameCells(const Map& a, const Map& b) {
  return a.width() == b.width() && a.height() == b.height() &&
         a.grid.getRawMap() == b.grid.getRawMap();
}

}  // namespace sbox::test
