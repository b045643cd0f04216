// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "catch.h"
#include "sbox/core/state_grid.h"

using namespace sbox;

namespace {

/// Cells of probability 0.05, 0.5 and 0.95 for '#', ' ' and '.', the top row first.
Map drawn(const std::vector<std::string>& rows, double resolution, const Pose2D& corner) {
  const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows[0].size());
  Map map = makeMap("drawn", width, height, resolution, corner);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const char cell = rows[static_cast<size_t>(height - 1 - y)][static_cast<size_t>(x)];
      map.grid.setCell(x, y, cell == '#' ? 0.05F : cell == '.' ? 0.95F : 0.5F);
    }
  }
  return map;
}

std::vector<std::string> drawing(const StateGrid& grid) {
  std::vector<std::string> rows;
  for (int y = grid.height - 1; y >= 0; --y) {
    rows.emplace_back();
    for (int x = 0; x < grid.width; ++x) {
      const CellState state = grid.at(x, y);
      rows.back() += state == CellState::Occupied ? '#' : state == CellState::Free ? '.' : ' ';
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("cells are classified and cropped to what is known") {
  const StateGrid grid = classifyCells(drawn({"      ",  //
                                              "  #.  ",  //
                                              "   .  ",  //
                                              "      ",  //
                                              "      "},
                                             0.5, {10, 20, M_PI / 2}));
  CHECK(drawing(grid) == std::vector<std::string>{"#.", " ."});
  CHECK(grid.resolution == 0.5);
  // Two cells along the rows, which point up, and two along the columns, which point left.
  CHECK(grid.corner_in_map.x == Approx(9));
  CHECK(grid.corner_in_map.y == Approx(21));
  CHECK(grid.corner_in_map.phi == Approx(M_PI / 2));
}

TEST_CASE("a map without a known cell has no states") {
  CHECK(classifyCells(makeMap("blank", 7, 5, 0.1)).empty());
}

TEST_CASE("one occupied cell anywhere is found") {
  Map map = drawn({"...", ". .", "..."}, 0.1, {});
  CHECK_FALSE(hasOccupiedCell(map));
  map.grid.setCell(2, 2, 0.05F);
  CHECK(hasOccupiedCell(map));
  CHECK_FALSE(hasOccupiedCell(map, {0.6, 0.01}));
}

TEST_CASE("classifying agrees with each cell looked up alone") {
  std::mt19937 random(3);
  const StateOptions options{0.7, 0.2};
  Map map = makeMap("noise", 90, 70, 0.05);
  for (int y = 10; y < 60; ++y) {
    for (int x = 20; x < 80; ++x) {
      map.grid.setCell(x, y, static_cast<float>(random() % 101) / 100);
    }
  }
  const StateGrid grid = classifyCells(map, options);
  const auto column = static_cast<int>(std::lround(grid.corner_in_map.x / 0.05));
  const auto row = static_cast<int>(std::lround(grid.corner_in_map.y / 0.05));
  int known = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const double p_free = map.grid.getCell(x, y);
      const CellState expected = p_free >= options.free_above      ? CellState::Free
                                 : p_free < options.occupied_below ? CellState::Occupied
                                                                   : CellState::Unknown;
      CHECK(grid.at(x - column, y - row) == expected);
      known += expected != CellState::Unknown ? 1 : 0;
    }
  }
  CHECK(known > 1000);
}

TEST_CASE("coarser cells are occupied if any cell is, and free if all are") {
  // The last column is half beyond the map, which is unknown.
  const StateGrid grid = classifyCells(drawn({"....#",  //
                                              "... .",  //
                                              "#....",  //
                                              "....."},
                                             0.1, {}));
  CHECK(drawing(resample(grid, 0.2)) == std::vector<std::string>{". #", "#. "});
  CHECK(drawing(resample(classifyCells(drawn({"#.", ".."}, 0.2, {})), 0.1)) ==
        std::vector<std::string>{"##..", "##..", "....", "...."});
}

TEST_CASE("coarser cells that overlap close walls whose cells meet at corners") {
  const StateGrid grid = classifyCells(drawn({"..#.....",  //
                                              "...#....",  //
                                              "....#...",  //
                                              ".....#..",  //
                                              "......#.",  //
                                              ".......#"},
                                             0.1, {}));
  CHECK(drawing(resample(grid, 0.2)) == std::vector<std::string>{".#..", "..#.", "...#"});
  CHECK(drawing(resample(grid, 0.2, 1)) == std::vector<std::string>{".##.", "..##", "...#"});
  // Finer cells have nothing to take in.
  CHECK(drawing(resample(grid, 0.05, 1)) == drawing(resample(grid, 0.05)));
}

TEST_CASE("any resampling agrees with each cell looked up alone") {
  std::mt19937 random(5);
  Map map = makeMap("noise", 61, 53, 0.05);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const auto kind = random() % 12;
      map.grid.setCell(x, y, kind == 0 ? 0.05F : kind == 1 ? 0.5F : 0.95F);
    }
  }
  const StateGrid grid = classifyCells(map);
  for (const int times : {2, 3, 4}) {
    for (const int overlap : {0, 1, 2}) {
      const StateGrid coarse = resample(grid, times * 0.05, overlap);
      REQUIRE(coarse.width == (grid.width + times - 1) / times);
      REQUIRE(coarse.height == (grid.height + times - 1) / times);
      for (int y = 0; y < coarse.height; ++y) {
        for (int x = 0; x < coarse.width; ++x) {
          bool any_occupied = false, all_free = true;
          for (int cy = std::max(0, y * times - overlap); cy < (y + 1) * times; ++cy) {
            for (int cx = std::max(0, x * times - overlap); cx < (x + 1) * times; ++cx) {
              any_occupied = any_occupied || grid.at(cx, cy) == CellState::Occupied;
              all_free = all_free && grid.at(cx, cy) == CellState::Free;
            }
          }
          REQUIRE(coarse.at(x, y) == (any_occupied ? CellState::Occupied
                                      : all_free   ? CellState::Free
                                                   : CellState::Unknown));
        }
      }
    }
  }
}

TEST_CASE("rounded cell sizes add no slivers, however large the map") {
  // MRPT keeps 0.05 m in single precision: a little more.
  StateGrid grid;
  grid.width = 20000;
  grid.height = 1;
  grid.resolution = static_cast<double>(0.05F);
  grid.cells.assign(20000, CellState::Free);
  grid.cells[15001] = CellState::Occupied;
  const StateGrid coarse = resample(grid, 0.1);
  CHECK(coarse.width == 10000);
  CHECK(coarse.at(7500, 0) == CellState::Occupied);
  CHECK(std::count(coarse.cells.begin(), coarse.cells.end(), CellState::Occupied) == 1);
}

TEST_CASE("resampling to more cells than can be held is refused") {
  StateGrid grid = classifyCells(drawn({"#.", ".."}, 100, {}));
  CHECK_THROWS_AS(resample(grid, 0.001), std::length_error);
  CHECK(resample(grid, 1).width == 200);
}
