// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The three states that features and verification read: free, occupied, unknown.
#pragma once

#include <cstdint>
#include <vector>

#include "sbox/core/map.h"

namespace sbox {

/// What a cell is taken for.
enum class CellState : std::uint8_t { Unknown = 0, Free = 1, Occupied = 2 };

/// A grid of cell states, cropped to what is known.
struct StateGrid {
  int width = 0;                 ///< Cells in a row.
  int height = 0;                ///< Cells in a column.
  double resolution = 0;         ///< Edge length of a cell, in metres.
  Pose2D corner_in_map;          ///< Lower-left corner of cell (0, 0) in the map frame.
  std::vector<CellState> cells;  ///< Row by row, lowest row first.

  /// State of cell (x, y); unknown outside the grid.
  [[nodiscard]] CellState at(int x, int y) const {
    return x < 0 || y < 0 || x >= width || y >= height
               ? CellState::Unknown
               : cells[static_cast<size_t>(y) * static_cast<size_t>(width) +
                       static_cast<size_t>(x)];
  }
  /// Whether no cell is known.
  [[nodiscard]] bool empty() const { return cells.empty(); }
};

/// Which cells count as free and which as occupied; the others count as unknown.
struct StateOptions {
  double free_above = 0.6;      ///< Probability of being free from which a cell counts as free.
  double occupied_below = 0.4;  ///< Probability of being free below which it counts as occupied.
};

/// The states of a map's cells, cropped to the bounding box of the known ones; empty if there are
/// none.
[[nodiscard]] StateGrid classifyCells(const Map& map, const StateOptions& options = {});

/// Whether any cell of the map is occupied.
[[nodiscard]] bool hasOccupiedCell(const Map& map, const StateOptions& options = {});

/// A grid is never resampled to more cells than this.
inline constexpr double max_resampled_cells = 4e8;

/// The same area in cells of `resolution` metres on the same corner. Coarser cells: occupied if any
/// cell they touch is, free if all are, `overlap` more of them to the left and below counted in;
/// finer cells: the state of the cell that holds their centre. Throws std::length_error where that
/// would take more than max_resampled_cells.
[[nodiscard]] StateGrid resample(const StateGrid& grid, double resolution, int overlap = 0);

}  // namespace sbox
