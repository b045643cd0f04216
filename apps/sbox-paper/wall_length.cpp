// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/wall_length.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sbox::paper {
namespace {

constexpr double kStep = 0.01;
constexpr double kBeyond = 1.0;

struct Cell {
  int x;
  int y;
};

Cell cellAt(const StateGrid& grid, const Point2D& point_in_map) {
  const Point2D p = grid.corner_in_map.inverseComposePoint(point_in_map);
  return {static_cast<int>(std::floor(p.x / grid.resolution)),
          static_cast<int>(std::floor(p.y / grid.resolution))};
}

/// Distance from `from` to the centre of the first occupied cell in direction `along`, projected on
/// it.
std::optional<double> freeWay(const StateGrid& grid, const Point2D& from, const Point2D& along,
                              double limit) {
  for (double at = 0; at <= limit; at += kStep) {
    const Cell cell = cellAt(grid, from + along * at);
    const CellState state = grid.at(cell.x, cell.y);
    if (state == CellState::Occupied) {
      const Point2D centre = grid.corner_in_map.composePoint(
          {(cell.x + 0.5) * grid.resolution, (cell.y + 0.5) * grid.resolution});
      return (centre.x - from.x) * along.x + (centre.y - from.y) * along.y;
    }
    if (at == 0 && state != CellState::Free) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> wallLength(const StateGrid& grid, const LineSegment& wall_in_map) {
  const double length = (wall_in_map.to - wall_in_map.from).norm();
  const Point2D along = (wall_in_map.to - wall_in_map.from) * (1 / length);
  const Point2D inwards(-along.y, along.x);
  const Point2D middle = (wall_in_map.from + wall_in_map.to) * 0.5;
  std::vector<double> lengths;
  for (double off = 0.15; off < 0.46; off += 0.05) {
    const Point2D start = middle + inwards * off;
    const auto ahead = freeWay(grid, start, along, length / 2 + kBeyond);
    const auto behind = freeWay(grid, start, along * -1.0, length / 2 + kBeyond);
    if (ahead && behind) {
      lengths.push_back(*ahead + *behind);
    }
  }
  if (lengths.empty()) {
    return std::nullopt;
  }
  std::sort(lengths.begin(), lengths.end());
  const size_t half = lengths.size() / 2;
  return lengths.size() % 2 == 1 ? lengths[half] : (lengths[half - 1] + lengths[half]) / 2;
}

}  // namespace sbox::paper
