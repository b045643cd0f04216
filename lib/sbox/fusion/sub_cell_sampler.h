// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads a map between its cells without opening gaps in walls or thickening them. The sign (wall or
// free) is that of the nearest cell, so areas are kept, but plain bilinear weights would cancel a
// one-cell wall against the free space beside it. Walls that touch only at their corners (every
// slanted wall of a grid) would fall apart under rotation; the neck between two such cells counts
// as wall, just as wide as a line of one lattice cell needs to be to stay connected.
#pragma once

#include <algorithm>
#include <cstdint>

#include "sbox/core/map.h"
#include "sbox/core/state_limits.h"
#include "sbox/fusion/cell_warp.h"

namespace sbox {

/// What a map says about a place, as MRPT's log-odds of being free; both 0 where it knows nothing.
struct CellEvidence {
  int whole = 0;  ///< Mean of the cells around that agree with the place's state.
  int net = 0;    ///< Mean of all known cells around, of whole's sign: weak beside a wall's edge.
};

/// Samples one map; keeps a pointer to its cells, which must outlive it.
class SubCellSampler {
 public:
  /// `neck_width` in map cells, see neckWidth().
  SubCellSampler(const Map& map, double neck_width);

  /// The evidence at a place anywhere.
  [[nodiscard]] CellEvidence at(const SubCell& place) const;

  /// Its CellEvidence::whole, faster, where all four cells around the place are cells of the map:
  /// insideLow() <= place < insideHigh().
  [[nodiscard]] int wholeInside(const SubCell& place) const {
    const CellLogOdds* cell = cells_ + (place.v >> 32) * stride_ + (place.u >> 32);
    const int a = cell[0], b = cell[1], c = cell[stride_], d = cell[stride_ + 1];
    if (a == b && c == d && a == c) {
      return a;
    }
    return ofOneSign(a, b, c, d) ? bilinear(a, b, c, d, fraction(place.u), fraction(place.v))
                                 : blend(place).whole;
  }
  /// Least place between the centres of cells.
  [[nodiscard]] static SubCell insideLow() { return {0, 0}; }
  /// One beyond the largest such place.
  [[nodiscard]] SubCell insideHigh() const {
    return {(width_ - 1) * kSubCellUnit, (height_ - 1) * kSubCellUnit};
  }

  /// Outside of reachLow() <= place < reachHigh() the map knows nothing.
  [[nodiscard]] static SubCell reachLow() { return {-kSubCellUnit, -kSubCellUnit}; }
  /// One beyond the largest place within the outer cells.
  [[nodiscard]] SubCell reachHigh() const {
    return {width_ * kSubCellUnit, height_ * kSubCellUnit};
  }

  /// Log-odds of the cell whose centre is nearest, moved by (dx, dy) cells; 0 outside the map.
  [[nodiscard]] int nearest(const SubCell& place, int dx = 0, int dy = 0) const {
    return cellAt(((place.u + kSubCellUnit / 2) >> 32) + dx,
                  ((place.v + kSubCellUnit / 2) >> 32) + dy);
  }

 private:
  /// Weights are counted in 1/256 of a cell.
  static constexpr int kOne = 256;

  static int fraction(std::int64_t position) {
    return static_cast<int>(((position & (kSubCellUnit - 1)) + (std::int64_t{1} << 23)) >> 24);
  }
  static bool ofOneSign(int a, int b, int c, int d) {
    return (a & b & c & d) < 0 || ((a - 1) | (b - 1) | (c - 1) | (d - 1)) >= 0;
  }
  /// Mean of the cells lower left, lower right, upper left and upper right of a place.
  static int bilinear(int a, int b, int c, int d, int fx, int fy) {
    const int lower = kOne * a + fx * (b - a), upper = kOne * c + fx * (d - c);
    return roundedRatio(kOne * lower + fy * (upper - lower), kOne * kOne);
  }
  static int roundedRatio(int sum, int weight) {
    return (sum < 0 ? sum - weight / 2 : sum + weight / 2) / weight;
  }
  [[nodiscard]] int cellAt(std::int64_t x, std::int64_t y) const {
    return x < 0 || y < 0 || x >= width_ || y >= height_ ? 0 : cells_[y * stride_ + x];
  }
  /// The evidence at a place between cells that do not all have one sign.
  [[nodiscard]] CellEvidence blend(const SubCell& place) const;
  /// Whether a place whose nearest cell is not occupied lies on the neck between two occupied cells
  /// that touch at their corners.
  [[nodiscard]] bool onNeck(const SubCell& place) const;

  const CellLogOdds* cells_;
  std::int64_t stride_;
  std::int64_t width_;
  std::int64_t height_;
  std::int64_t neck_half_;  ///< Half the width of a neck as cut by a row, in 2^-32 cells.
};

/// How wide a neck must be, in cells of the map, for corner-to-corner cells to stay connected on a
/// lattice turned by `angle` whose cells are `ratio` times as large (at most 1): the width of a
/// digital line in that direction. 0 for quarter turns, where cells stay cells.
[[nodiscard]] double neckWidth(double angle, double ratio);

}  // namespace sbox
