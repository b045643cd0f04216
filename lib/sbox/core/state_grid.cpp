// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/state_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sbox/core/cell_corner.h"
#include "sbox/core/cell_states.h"

namespace sbox {

using Cell = mrpt::maps::COccupancyGridMap2D::cellType;
static_assert(sizeof(Cell) == 1, "MRPT was built with 16-bit cells");

CellStates::CellStates(const StateOptions& options) {
  for (int value = -128; value <= 127; ++value) {
    const double p_free = mrpt::maps::COccupancyGridMap2D::l2p(static_cast<Cell>(value));
    states_[static_cast<std::uint8_t>(value)] = p_free >= options.free_above ? CellState::Free
                                                : p_free < options.occupied_below
                                                    ? CellState::Occupied
                                                    : CellState::Unknown;
  }
}

KnownPart knownPart(const Map& map, const CellStates& states) {
  const auto known = [&](Cell cell) { return states(cell) != CellState::Unknown; };
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
  return x_last < 0 ? KnownPart()
                    : KnownPart{x_first, y_first, x_last - x_first + 1, y_last - y_first + 1};
}

Pose2D cornerInMap(const Map& map, const KnownPart& part) {
  return cellCorner(map.corner_in_map, map.resolution(), part.x_first, part.y_first);
}

StateGrid classifyCells(const Map& map, const StateOptions& options) {
  const CellStates states(options);
  const KnownPart part = knownPart(map, states);
  StateGrid grid;
  grid.resolution = map.resolution();
  grid.corner_in_map = map.corner_in_map;
  if (part.width == 0) {
    return grid;
  }
  grid.width = part.width;
  grid.height = part.height;
  grid.corner_in_map = cornerInMap(map, part);
  grid.cells.resize(static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height));
  CellState* state = grid.cells.data();
  for (int y = part.y_first; y < part.y_first + part.height; ++y, state += grid.width) {
    const Cell* row = map.grid.getRow(y) + part.x_first;
    std::transform(row, row + grid.width, state, states);
  }
  return grid;
}

bool hasOccupiedCell(const Map& map, const StateOptions& options) {
  const CellStates states(options);
  for (int y = 0; y < map.height(); ++y) {
    const Cell* row = map.grid.getRow(y);
    if (std::any_of(row, row + map.width(),
                    [&](Cell cell) { return states(cell) == CellState::Occupied; })) {
      return true;
    }
  }
  return false;
}

StateGrid resample(const StateGrid& grid, double resolution) {
  StateGrid out;
  out.resolution = resolution;
  out.corner_in_map = grid.corner_in_map;
  if (grid.empty()) {
    return out;
  }
  const double ratio = resolution / grid.resolution;
  if (grid.width / ratio * (grid.height / ratio) > max_resampled_cells) {
    throw std::length_error(
        "a map of " + std::to_string(grid.width) + " x " + std::to_string(grid.height) +
        " known cells is too large to be matched in cells of " + std::to_string(resolution) + " m");
  }
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
  std::vector<std::pair<int, int>> columns;
  for (int x = 0; x < out.width; ++x) {
    columns.push_back(span(x, grid.width));
  }
  // A cell is occupied if the union of its bits has that bit, and free if their intersection has
  // that one; beyond the grid no bit is set.
  using Bits = std::uint8_t;
  constexpr auto free_bit = static_cast<Bits>(CellState::Free);
  constexpr auto occupied_bit = static_cast<Bits>(CellState::Occupied);
  std::vector<Bits> any(static_cast<size_t>(grid.width)), all(any.size());
  for (int y = 0; y < out.height; ++y) {
    const auto [y_first, y_last] = span(y, grid.height);
    std::fill(any.begin(), any.end(), Bits{0});
    std::fill(all.begin(), all.end(), y_last < grid.height ? free_bit : Bits{0});
    for (int cy = y_first; cy <= std::min(y_last, grid.height - 1); ++cy) {
      const CellState* row =
          grid.cells.data() + static_cast<size_t>(cy) * static_cast<size_t>(grid.width);
      for (size_t x = 0; x < any.size(); ++x) {
        const auto bits = static_cast<Bits>(row[x]);
        any[x] |= bits;
        all[x] &= bits;
      }
    }
    CellState* out_row = out.cells.data() + static_cast<size_t>(y) * static_cast<size_t>(out.width);
    for (int x = 0; x < out.width; ++x) {
      const auto [x_first, x_last] = columns[static_cast<size_t>(x)];
      Bits any_bits = 0, all_bits = x_last < grid.width ? free_bit : Bits{0};
      for (int cx = x_first; cx <= std::min(x_last, grid.width - 1); ++cx) {
        any_bits |= any[static_cast<size_t>(cx)];
        all_bits &= all[static_cast<size_t>(cx)];
      }
      out_row[x] = (any_bits & occupied_bit) != 0 ? CellState::Occupied
                   : all_bits != 0                ? CellState::Free
                                                  : CellState::Unknown;
    }
  }
  return out;
}

}  // namespace sbox
