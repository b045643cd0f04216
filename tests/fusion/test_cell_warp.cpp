// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/fusion/cell_warp.h"

using namespace sbox;

TEST_CASE("a warp gives the place of a lattice cell's centre in the map's cells", "[fusion]") {
  const Pose2D grid_in_lattice(3.2, -1.7, 2.1);
  const CellWarp warp(grid_in_lattice, 0.1, 0.05);
  const Point2D expected = grid_in_lattice.inverseComposePoint({(400 + 0.5) * 0.05, -299.5 * 0.05});
  const SubCell place = warp.at(400, -300);
  const auto unit = static_cast<double>(kSubCellUnit);
  CHECK(static_cast<double>(place.u) / unit == Approx(expected.x / 0.1 - 0.5));
  CHECK(static_cast<double>(place.v) / unit == Approx(expected.y / 0.1 - 0.5));
}

TEST_CASE("spanWithin finds the cells that a plain search finds", "[fusion]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const double angle = i % 5 == 0 ? i * M_PI / 2 : 4 * any(random);
    const CellWarp warp({any(random), any(random), angle}, 0.1, 0.1 - 0.05 * (i % 2));
    const SubCell low{0, -kSubCellUnit}, high{9 * kSubCellUnit, 7 * kSubCellUnit};
    const CellSpan row{-20, 25};
    const int y = i % 21 - 10;
    const CellSpan span = warp.spanWithin(row, y, low, high);
    int wrong = 0;
    for (int x = row.first; x < row.end; ++x) {
      const SubCell at = warp.at(x, y);
      const bool within = at.u >= low.u && at.u < high.u && at.v >= low.v && at.v < high.v;
      wrong += within != (x >= span.first && x < span.end) ? 1 : 0;
    }
    REQUIRE(wrong == 0);
  }
}
