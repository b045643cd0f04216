// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <random>
#include <set>

#include "catch.h"
#include "drawing.h"
#include "sbox/features/free_contours.h"

using namespace sbox;
using test::gridFromText;

namespace {

using Cells = std::set<std::pair<int, int>>;

Cells cellsOf(const std::vector<FreeContour>& contours) {
  Cells cells;
  for (const FreeContour& contour : contours) {
    for (const ContourCell& cell : contour) {
      cells.insert({cell.x, cell.y});
    }
  }
  return cells;
}

/// Twice the area that the walk has to its left, less what it has to its right.
int signedArea(const FreeContour& walk) {
  int area = 0;
  for (size_t i = 0; i < walk.size(); ++i) {
    const ContourCell& to = walk[(i + 1) % walk.size()];
    area += walk[i].x * to.y - to.x * walk[i].y;
  }
  return area;
}

StateGrid randomGrid(unsigned seed) {
  std::mt19937 random(seed);
  StateGrid grid = test::freeGrid(24, 17, 0.1);
  for (CellState& cell : grid.cells) {
    const auto dice = random() % 10;
    cell = dice < 6 ? CellState::Free : dice < 8 ? CellState::Occupied : CellState::Unknown;
  }
  return grid;
}

bool occupiedWithin(const StateGrid& grid, const ContourCell& cell, int reach) {
  for (int y = cell.y - reach; y <= cell.y + reach; ++y) {
    for (int x = cell.x - reach; x <= cell.x + reach; ++x) {
      if (grid.at(x, y) == CellState::Occupied) {
        return true;
      }
    }
  }
  return false;
}

/// Whether a cell is free, and does not touch another only at a corner.
bool isOpen(const StateGrid& grid, int x, int y) {
  const auto is_free = [&](int dx, int dy) { return grid.at(x + dx, y + dy) == CellState::Free; };
  for (const int dx : {-1, 1}) {
    for (const int dy : {-1, 1}) {
      if (is_free(dx, dy) && !is_free(dx, 0) && !is_free(0, dy)) {
        return false;
      }
    }
  }
  return is_free(0, 0);
}

}  // namespace

TEST_CASE("the outline of a room is walked once, its inside on the left", "[features]") {
  const auto contours = traceFreeContours(gridFromText({"#######",  //
                                                        "#.....#",  //
                                                        "#.....#",  //
                                                        "#.....#",  //
                                                        "#######"},
                                                       0.1));
  REQUIRE(contours.size() == 1);
  CHECK(contours[0].size() == 12);
  CHECK(cellsOf(contours).size() == 12);
  CHECK(cellsOf(contours).count({3, 2}) == 0);
  CHECK(signedArea(contours[0]) == 2 * 4 * 2);
  for (const ContourCell& cell : contours[0]) {
    CHECK(cell.at_wall);
  }
}

TEST_CASE("round a pillar the walk goes the other way", "[features]") {
  const auto contours = traceFreeContours(gridFromText({".......",  //
                                                        ".......",  //
                                                        "...#...",  //
                                                        ".......",  //
                                                        "......."},
                                                       0.1));
  REQUIRE(contours.size() == 2);
  const bool first_is_outer = contours[0].size() > contours[1].size();
  const FreeContour& outer = contours[first_is_outer ? 0 : 1];
  const FreeContour& round_pillar = contours[first_is_outer ? 1 : 0];
  CHECK(signedArea(outer) > 0);
  CHECK(signedArea(round_pillar) < 0);
  CHECK(cellsOf({round_pillar}) == Cells{{3, 1}, {2, 2}, {4, 2}, {3, 3}});
}

TEST_CASE("free space that ends at the unknown has no wall there", "[features]") {
  // A wall to the left, one behind a sliver of the unknown to the right, none above or below.
  const auto contours = traceFreeContours(gridFromText({"#........ #",  //
                                                        "#........ #",  //
                                                        "#........ #"},
                                                       0.1));
  REQUIRE(contours.size() == 1);
  for (const ContourCell& cell : contours[0]) {
    if (cell.x == 1 || cell.x == 8) {
      CHECK(cell.at_wall);
    } else if (cell.x > 2 && cell.x < 7) {
      CHECK_FALSE(cell.at_wall);
    }
  }
}

TEST_CASE("specks are passed over", "[features]") {
  const StateGrid grid = gridFromText({".  ....",  //
                                       "   ....",  //
                                       ".. ...."},
                                      0.1);
  CHECK(traceFreeContours(grid).size() == 1);
  ContourOptions options;
  options.min_cells = 1;
  CHECK(traceFreeContours(grid, options).size() == 3);
  options.min_cells = 11;
  CHECK(traceFreeContours(grid, options).empty());
}

TEST_CASE("nothing free has no outline", "[features]") {
  CHECK(traceFreeContours(StateGrid()).empty());
  CHECK(traceFreeContours(gridFromText({"###", "# #", "###"}, 0.1)).empty());
}

TEST_CASE("a slanted wall one cell thick parts two rooms", "[features]") {
  const StateGrid grid = gridFromText({"##########",  //
                                       "#...#....#",  //
                                       "#....#...#",  //
                                       "#.....#..#",  //
                                       "#......#.#",  //
                                       "##########"},
                                      0.1);
  const auto contours = traceFreeContours(grid);
  REQUIRE(contours.size() == 2);
  for (const FreeContour& contour : contours) {
    CHECK(signedArea(contour) > 0);
    const auto right_of_wall = [](const ContourCell& cell) { return cell.x + cell.y > 8; };
    CHECK(std::all_of(contour.begin(), contour.end(), right_of_wall) !=
          std::none_of(contour.begin(), contour.end(), right_of_wall));
  }
  ContourOptions options;
  options.close_corners = false;
  // One outline round both, and others round the wall.
  const auto joined = traceFreeContours(grid, options);
  CHECK(std::count_if(joined.begin(), joined.end(),
                      [](const FreeContour& contour) { return signedArea(contour) > 0; }) == 1);
}

TEST_CASE("the outlines of any grid are all open cells beside one that is not", "[features]") {
  ContourOptions options;
  options.min_cells = 1;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const StateGrid grid = randomGrid(seed);
    Cells expected;
    for (int y = 0; y < grid.height; ++y) {
      for (int x = 0; x < grid.width; ++x) {
        if (isOpen(grid, x, y) && !(isOpen(grid, x + 1, y) && isOpen(grid, x - 1, y) &&
                                    isOpen(grid, x, y + 1) && isOpen(grid, x, y - 1))) {
          expected.insert({x, y});
        }
      }
    }
    const auto contours = traceFreeContours(grid, options);
    INFO("seed " << seed);
    CHECK(cellsOf(contours) == expected);
    for (const FreeContour& contour : contours) {
      for (size_t i = 0; i < contour.size(); ++i) {
        const ContourCell& from = contour[i];
        const ContourCell& to = contour[(i + 1) % contour.size()];
        const int dx = to.x - from.x, dy = to.y - from.y;
        REQUIRE(std::max(std::abs(dx), std::abs(dy)) <= 1);
        if (std::abs(dx) + std::abs(dy) == 1) {
          // To the right of a straight step open space ends.
          CHECK_FALSE(
              (isOpen(grid, from.x + dy, from.y - dx) && isOpen(grid, to.x + dy, to.y - dx)));
        }
        if (occupiedWithin(grid, from, 1)) {
          CHECK(from.at_wall);
        } else if (!occupiedWithin(grid, from, 2)) {
          CHECK_FALSE(from.at_wall);
        }
      }
    }
  }
}
