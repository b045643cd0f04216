// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/fusion/cell_box.h"
#include "sbox/fusion/cell_warp.h"
#include "sbox/fusion/lattice.h"
#include "sbox/fusion/placed_map.h"
#include "sbox/fusion/sub_cell_sampler.h"

namespace sbox {

/// A map laid on the lattice.
struct MapLayer {
  CellWarp warp;           ///< From lattice cells to the map's.
  SubCellSampler sampler;  ///< Reads the map at a place that warp gives.
  CellBox box;             ///< The least rectangle of lattice cells that holds all it knows.
  /// Lattice cells along a map cell's edge if the map's cells are taken as they are, else 0.
  int lattice_cells_per_cell = 0;
  const Map* map = nullptr;  ///< Not owned.

  /// What the map says about lattice cell (x, y).
  [[nodiscard]] CellEvidence at(int x, int y) const;
};

/// Lays a map on the lattice, its box being the hull of the lattice cells at which it knows
/// something. `is_reference` marks the map whose cells the lattice follows. Throws
/// std::length_error if the map would lie more than 2^30 cells from the lattice's origin.
[[nodiscard]] MapLayer layMap(const PlacedMap& placed, const Lattice& lattice, bool is_reference);

}  // namespace sbox
