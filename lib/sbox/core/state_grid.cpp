// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/state_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sbox/core/known_part.h"

namespace sbox {
namespace {

/// States in the order in which they win over others when cells are joined.
enum class Badness : std::uint8_t { Free, Unknown, Occupied };

Badness badnessOf(CellState state) {
  return state == CellState::Free      ? Badness::Free
         : state == CellState::Unknown ? Badness::Unknown
                                       : Badness::Occupied;
}

CellState stateOf(Badness badness) {
  return badness == Badness::Free      ? CellState::Free
         : badness == Badness::Unknown ? CellState::Unknown
                                       : CellState::Occupied;
}

}  // namespace

StateGrid classifyCells(const Map& map, const StateOptions& options) {
  const StateLimits limits = stateLimits(options);
  const KnownPart part = knownPart(map, limits);
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
    const CellLogOdds* row = map.grid.getRow(y) + part.x_first;
    std::transform(row, row + grid.width, state,
                   [limits](CellLogOdds cell) { return limits.stateOf(cell); });
  }
  return grid;
}

bool hasOccupiedCell(const Map& map, const StateOptions& options) {
  const StateLimits limits = stateLimits(options);
  for (int y = 0; y < map.height(); ++y) {
    const CellLogOdds* row = map.grid.getRow(y);
    if (std::any_of(row, row + map.width(),
                    [&](CellLogOdds cell) { return cell <= limits.occupied_to; })) {
      return true;
    }
  }
  return false;
}

StateGrid resample(const StateGrid& grid, double resolution, int overlap) {
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
  // A sliver of a cell is not a cell: MRPT's cell sizes are rounded to single precision, which adds
  // up over thousands of cells.
  constexpr double sliver = 0.01;
  out.width = std::max(1, static_cast<int>(std::ceil(grid.width / ratio - sliver)));
  out.height = std::max(1, static_cast<int>(std::ceil(grid.height / ratio - sliver)));
  out.cells.resize(static_cast<size_t>(out.width) * static_cast<size_t>(out.height));
  const auto span = [&](int i, int size) {
    if (ratio <= 1) {
      const int centre = std::min(static_cast<int>((i + 0.5) * ratio), size - 1);
      return std::pair<int, int>{centre, centre};
    }
    const int first = static_cast<int>(i * ratio + sliver);
    const int last = static_cast<int>(std::ceil((i + 1) * ratio - sliver)) - 1;
    return std::pair<int, int>{first, last};
  };
  std::vector<std::pair<int, int>> columns;
  for (int x = 0; x < out.width; ++x) {
    columns.push_back(span(x, grid.width));
  }
  // Most maps have such cells; compilers work on many of these at once.
  const bool are_halves =
      columns.back() == std::pair<int, int>{2 * out.width - 2, 2 * out.width - 1};
  if (ratio <= 1) {
    overlap = 0;
  }
  // The worst of all cells in each column, row by row of the result; beyond the grid all is
  // unknown.
  std::vector<Badness> worst(static_cast<size_t>(std::max(grid.width, columns.back().second + 1)));
  std::vector<Badness> wider(worst.size());
  const auto grid_width = static_cast<size_t>(grid.width);
  for (int y = 0; y < out.height; ++y) {
    const auto [y_first, y_last] = span(y, grid.height);
    std::fill(worst.begin(), worst.end(), y_last < grid.height ? Badness::Free : Badness::Unknown);
    std::fill(worst.begin() + grid.width, worst.end(), Badness::Unknown);
    for (int cy = std::max(0, y_first - overlap); cy <= std::min(y_last, grid.height - 1); ++cy) {
      const CellState* row = grid.cells.data() + static_cast<size_t>(cy) * grid_width;
      for (size_t x = 0; x < grid_width; ++x) {
        worst[x] = std::max(worst[x], badnessOf(row[x]));
      }
    }
    for (int i = 0; i < overlap; ++i) {
      std::transform(worst.begin(), worst.end() - 1, worst.begin() + 1, wider.begin() + 1,
                     [](Badness left, Badness right) { return std::max(left, right); });
      wider[0] = worst[0];
      std::swap(worst, wider);
    }
    CellState* out_row = out.cells.data() + static_cast<size_t>(y) * static_cast<size_t>(out.width);
    if (are_halves) {
      for (size_t x = 0; x < columns.size(); ++x) {
        out_row[x] = stateOf(std::max(worst[2 * x], worst[2 * x + 1]));
      }
      continue;
    }
    for (size_t x = 0; x < columns.size(); ++x) {
      const auto [x_first, x_last] = columns[x];
      out_row[x] = stateOf(*std::max_element(worst.begin() + x_first, worst.begin() + x_last + 1));
    }
  }
  return out;
}

}  // namespace sbox
