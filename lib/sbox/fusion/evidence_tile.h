// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sbox/fusion/cell_box.h"
#include "sbox/fusion/cell_tally.h"
#include "sbox/fusion/map_layer.h"

namespace sbox {

/// The evidence for a rectangle of lattice cells, small enough to stay in a core's cache.
class EvidenceTile {
 public:
  /// Forgets everything and moves to these cells.
  void reset(const CellBox& cells);
  /// Adds what a map knows about the tile's cells; false if it lies beside them.
  bool add(const MapLayer& layer);

  /// The lattice cells it covers.
  [[nodiscard]] const CellBox& cells() const { return cells_; }
  /// Tallies of the tile's row y (lattice cells), from x_first on.
  [[nodiscard]] const CellTally* row(int y) const {
    return tallies_.data() + static_cast<std::size_t>(y - cells_.y_first) * width();
  }

 private:
  [[nodiscard]] std::size_t width() const {
    return static_cast<std::size_t>(cells_.x_end - cells_.x_first);
  }
  [[nodiscard]] CellTally* cell(int x, int y) {
    return tallies_.data() + static_cast<std::size_t>(y - cells_.y_first) * width() +
           (x - cells_.x_first);
  }
  void addAsIs(const MapLayer& layer, const CellBox& cells);
  void addWarped(const MapLayer& layer, const CellBox& cells);

  CellBox cells_;
  std::vector<CellTally> tallies_;
};

}  // namespace sbox
