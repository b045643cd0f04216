// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/state_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sbox {
namespace {

using Cell = mrpt::maps::COccupancyGridMap2D::cellType;

/// State of each of the 256 values a cell can have, by its bits.
std::array<CellState, 256> stateTable(const StateOptions& options) {
  std::array<CellState, 256> table{};
  for (int value = -128; value <= 127; ++value) {
    const double p_free = mrpt::maps::COccupancyGridMap2D::l2p(static_cast<Cell>(value));
    table[static_cast<std::uint8_t>(value)] = p_free >= options.free_above ? CellState::Free
                                              : p_free < options.occupied_below
                                                  ? CellState::Occupied
                                                  : CellState::Unknown;
  }
  return table;
}

}  // namespace

StateGrid classifyCells(const Map& map, const StateOptions& options) {
  static_assert(sizeof(Cell) == 1, "MRPT was built with 16-bit cells");
  const std::array<CellState, 256> states = stateTable(options);
  const auto known = [&](Cell cell) {
    return states[static_cast<std::uint8_t>(cell)] != CellState::Unknown;
  };
  int x_first = map.width(), x_last = -1, y_first = map.height(), y_last = -1;
  for (int y = 0; y < map.height(); ++y) {
    const Cell* row = map.grid.getRow(y);
    const Cell* end = row + map.width();
    const Cell* first = std::find_if(row, end, known);
    if (first == end) {
      continue;
    }
    const Cell* last = end - 1;
    while (!known(*last)) {
      --last;
    }
    x_first = std::min(x_first, static_cast<int>(first - row));
    x_last = std::max(x_last, static_cast<int>(last - row));
    y_first = std::min(y_first, y);
    y_last = y;
  }
  StateGrid grid;
  grid.resolution = map.resolution();
  grid.corner_in_map = map.corner_in_map;
  if (x_last < 0) {
    return grid;
  }
  grid.width = x_last - x_first + 1;
  grid.height = y_last - y_first + 1;
  const Point2D corner =
      map.corner_in_map.composePoint({x_first * grid.resolution, y_first * grid.resolution});
  grid.corner_in_map.x = corner.x;
  grid.corner_in_map.y = corner.y;
  grid.cells.reserve(static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height));
  for (int y = y_first; y <= y_last; ++y) {
    const Cell* row = map.grid.getRow(y);
    for (int x = x_first; x <= x_last; ++x) {
      grid.cells.push_back(states[static_cast<std::uint8_t>(row[x])]);
    }
  }
  return grid;
}

StateGrid resample(const StateGrid& grid, double resolution) {
  StateGrid out;
  out.resolution = resolution;
  out.corner_in_map = grid.corner_in_map;
  if (grid.empty()) {
    return out;
  }
  const double ratio = resolution / grid.resolution;
  // A sliver of a cell from rounding is not a cell.
  out.width = std::max(1, static_cast<int>(std::ceil(grid.width / ratio - 1e-6)));
  out.height = std::max(1, static_cast<int>(std::ceil(grid.height / ratio - 1e-6)));
  out.cells.assign(static_cast<size_t>(out.width) * static_cast<size_t>(out.height),
                   CellState::Unknown);
  const auto span = [&](int i, int size) {
    if (ratio <= 1) {
      const int centre = std::min(static_cast<int>((i + 0.5) * ratio), size - 1);
      return std::pair<int, int>{centre, centre};
    }
    const int first = static_cast<int>(i * ratio + 1e-6);
    const int last = static_cast<int>(std::ceil((i + 1) * ratio - 1e-6)) - 1;
    return std::pair<int, int>{first, last};
  };
  for (int y = 0; y < out.height; ++y) {
    const auto [y_first, y_last] = span(y, grid.height);
    for (int x = 0; x < out.width; ++x) {
      const auto [x_first, x_last] = span(x, grid.width);
      bool any_occupied = false, all_free = true;
      for (int cy = y_first; cy <= y_last; ++cy) {
        for (int cx = x_first; cx <= x_last; ++cx) {
          const CellState state = grid.at(cx, cy);
          any_occupied = any_occupied || state == CellState::Occupied;
          all_free = all_free && state == CellState::Free;
        }
      }
      out.cells[static_cast<size_t>(y) * static_cast<size_t>(out.width) + static_cast<size_t>(x)] =
          any_occupied ? CellState::Occupied
          : all_free   ? CellState::Free
                       : CellState::Unknown;
    }
  }
  return out;
}

}  // namespace sbox
