// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "drawing.h"
#include "sbox/paper/hough_votes.h"

using namespace sbox;

namespace {

/// Occupied cells whose distance rounds to that of the bin.
int countCells(const StateGrid& grid, double theta, double rho, double rho_step) {
  int count = 0;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const double px = (x + 0.5) * grid.resolution, py = (y + 0.5) * grid.resolution;
      const double offset = (px * std::cos(theta) + py * std::sin(theta) - rho) / rho_step;
      if (grid.at(x, y) == CellState::Occupied && offset >= -0.5 && offset < 0.5) {
        ++count;
      }
    }
  }
  return count;
}

StateGrid randomGrid() {
  StateGrid grid = test::freeGrid(23, 17, 0.1);
  std::mt19937 random(7);
  for (CellState& cell : grid.cells) {
    cell = random() % 4 == 0 ? CellState::Occupied : CellState::Free;
  }
  return grid;
}

}  // namespace

TEST_CASE("each bin holds the occupied cells on its line", "[paper]") {
  const StateGrid grid = randomGrid();
  // Neither step is a multiple of the cells', so that no cell lies on the edge of a bin.
  const double rho_step = 0.1237;
  const HoughVotes table(grid, 0.31, rho_step);
  int total = 0;
  for (int bin = 0; bin < table.bins(); ++bin) {
    REQUIRE(table.votes(bin) == countCells(grid, table.theta(bin), table.rho(bin), rho_step));
    total += table.votes(bin);
  }
  const auto cells = std::count(grid.cells.begin(), grid.cells.end(), CellState::Occupied);
  CHECK(total == 10 * cells);  // pi / 0.31 rounds to ten angles.
}

TEST_CASE("withdrawing every cell empties the table", "[paper]") {
  const StateGrid grid = randomGrid();
  HoughVotes table(grid, 0.1, 0.1);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (grid.at(x, y) == CellState::Occupied) {
        table.withdraw(x, y);
      }
    }
  }
  for (int bin = 0; bin < table.bins(); ++bin) {
    REQUIRE(table.votes(bin) == 0);
  }
}
