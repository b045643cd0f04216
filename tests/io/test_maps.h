// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "sbox/core/map.h"

/// A map with each of the 256 values a cell can have, in random order.
inline sbox::Map randomMap(int width, int height, double resolution,
                           const sbox::Pose2D& corner_in_map, unsigned seed = 1) {
  sbox::Map map = sbox::makeMap("random", width, height, resolution, corner_in_map);
  std::mt19937 random(seed);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      map.grid.getRow(y)[x] = static_cast<std::int8_t>(static_cast<int>(random() % 256) - 128);
    }
  }
  return map;
}

/// A map from a drawing, top row first: '#' occupied, '.' free, ' ' unknown.
inline sbox::Map drawnMap(const std::vector<std::string>& rows, double resolution,
                          const sbox::Pose2D& corner_in_map = {}) {
  const int height = static_cast<int>(rows.size());
  sbox::Map map = sbox::makeMap("drawn", static_cast<int>(rows.front().size()), height, resolution,
                                corner_in_map);
  for (int y = 0; y < height; ++y) {
    const std::string& row = rows[static_cast<std::size_t>(height - 1 - y)];
    for (int x = 0; x < map.width(); ++x) {
      const char c = row[static_cast<std::size_t>(x)];
      map.grid.setCell(x, y, c == '#' ? 0.02F : c == '.' ? 0.97F : 0.5F);
    }
  }
  return map;
}

/// The reverse of drawnMap, by the thresholds that the library takes for states.
inline std::vector<std::string> drawing(const sbox::Map& map) {
  std::vector<std::string> rows;
  for (int y = map.height() - 1; y >= 0; --y) {
    std::string row;
    for (int x = 0; x < map.width(); ++x) {
      const float p_free = map.grid.getCell(x, y);
      row.push_back(p_free < 0.4F ? '#' : p_free >= 0.6F ? '.' : ' ');
    }
    rows.push_back(row);
  }
  return rows;
}
