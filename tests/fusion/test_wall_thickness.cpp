// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rotating a map must neither tear its walls nor thicken them.
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "catch.h"
#include "fusion/literal_map.h"
#include "sbox/fusion/fuse_maps.h"

using namespace sbox;
using namespace sbox::test;

namespace {

constexpr int kLength = 80;  ///< Of the wall, in cells.

/// A digital line of one cell's width at `angle`, free space on both or on one of its sides.
Map slantedWall(double angle, bool both_sides) {
  const int size = kLength + 11, middle = size / 2;
  Map map = makeMap("wall", size, size, 0.05, {-0.05 * (middle + 0.5), -0.05 * (middle + 0.5), 0});
  const double c = std::cos(angle), s = std::sin(angle), major = std::max(std::abs(c), std::abs(s));
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double along = c * (x - middle) + s * (y - middle);
      const double across = (c * (y - middle) - s * (x - middle)) / major;
      if (std::abs(along) > kLength / 2) {
        continue;
      }
      const bool wall = across > -0.5 && across <= 0.5;
      const bool free = !wall && (both_sides || across > 0);
      setCell(&map, x, y, wall ? kOccupied : free ? kFree : 0);
    }
  }
  return map;
}

/// Occupied cells, and how many pieces they fall into if cells may touch at their corners.
std::pair<int, int> wallCellsAndPieces(const Map& map) {
  int cells = 0, pieces = 0;
  std::vector<char> seen(map.grid.getRawMap().size(), 0);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      std::vector<std::pair<int, int>> stack{{x, y}};
      bool first = true;
      while (!stack.empty()) {
        const auto [cx, cy] = stack.back();
        stack.pop_back();
        if (cellAt(map, cx, cy) >= 0) {
          continue;
        }
        char& mark = seen[static_cast<size_t>(cy) * static_cast<size_t>(map.width()) +
                          static_cast<size_t>(cx)];
        if (mark != 0) {
          continue;
        }
        mark = 1;
        ++cells;
        pieces += first ? 1 : 0;
        first = false;
        for (int d = 0; d < 9; ++d) {
          stack.emplace_back(cx + d % 3 - 1, cy + d / 3 - 1);
        }
      }
    }
  }
  return {cells, pieces};
}

}  // namespace

TEST_CASE("a turned wall stays whole and as thick as it was", "[fusion]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any_angle(-M_PI, M_PI), any_shift(-0.05, 0.05);
  const Map nothing = makeMap("nothing", 1, 1, 0.05);
  const bool both_sides = GENERATE(false, true);
  double cells = 0, wall_length = 0;
  int torn = 0;
  for (int i = 0; i < 300; ++i) {
    const double wall_angle = i % 4 == 0 ? 0 : any_angle(random);
    const double turn = i % 7 == 0 ? -wall_angle : i % 5 == 0 ? M_PI / 4 : any_angle(random);
    const Map wall = slantedWall(wall_angle, both_sides);
    const FusionResult result =
        fuseMaps({{&nothing, {}}, {&wall, {any_shift(random), any_shift(random), turn}}}, 0);
    const auto [count, pieces] = wallCellsAndPieces(result.merged);
    torn += pieces > 1 ? 1 : 0;
    cells += count;
    wall_length += kLength + 1;
  }
  CHECK(torn == 0);
  // A digital line of one cell's width has 0.71 to 1 cells a unit of length, an area of that
  // width 1.
  CHECK(cells / wall_length > 0.9);
  CHECK(cells / wall_length < 1.05);
}
