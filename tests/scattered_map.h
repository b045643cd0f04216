// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Features of maps that never were: walls anywhere, so that each of them can be asked one by one.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "drawing.h"
#include "sbox/features/map_features.h"

namespace sbox::test {

/// A map's cells, and features that were not found in them.
struct ScatteredMap {
  StateGrid grid;
  MapFeatures features;
};

/// 8 m x 6 m with obstacles and unknown cells anywhere. Normals are a few degrees from the middle
/// of a sector, so that two walls face the same way or clearly do not.
inline ScatteredMap scatteredMap(unsigned seed, int walls = 80) {
  constexpr double pi = 3.14159265358979323846;
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  ScatteredMap map;
  map.grid = freeGrid(80, 60, 0.1);
  for (int i = 0; i < 6; ++i) {
    const Point2D from(between(0, 8), between(0, 6));
    drawWall(map.grid, {from, from + Point2D(between(-1, 1), between(-1, 1))});
  }
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 20; ++x) {
      map.grid.cells[static_cast<size_t>(y * 80 + x)] = CellState::Unknown;
    }
  }
  MapFeatures& features = map.features;
  features.resolution = 0.1;
  features.width = 8;
  features.height = 6;
  for (int i = 0; i < walls; ++i) {
    const double facing = std::floor(between(0, kSectors)) * pi / 4 + between(-5, 5) * pi / 180;
    features.wall_points.push_back(
        {{between(0, 8), between(0, 6)}, {std::cos(facing), std::sin(facing)}, between(0, 2)});
    features.wall_directions.push_back(toByteAngle(facing));
  }
  features.point_spacing = 0.2;
  for (int i = 0; i < walls; ++i) {
    features.free_points.emplace_back(between(0, 8), between(0, 6));
  }
  features.free_point_area = 0.16;
  features.fields = makeFields(map.grid, features.wall_points);
  return map;
}

/// Whether two unit vectors point the same way to within half a sector.
inline bool facesAlike(const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
  constexpr double half_sector = 3.14159265358979323846 / 8;
  return left.dot(right) > std::cos(half_sector);
}

}  // namespace sbox::test
