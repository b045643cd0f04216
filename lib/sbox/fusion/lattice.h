// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sbox/core/pose.h"
#include "sbox/fusion/placed_map.h"

namespace sbox {

/// The endless lattice of cells that the merged map is cut from: the reference map's own, cell
/// (0, 0) on the reference's corner. If another map is finer, each reference cell falls into
/// `per_reference_cell` squared lattice cells; where the finest cell size does not divide the
/// reference's, the lattice takes that size and the reference is resampled as any other map.
struct Lattice {
  double resolution = 0;       ///< Edge length of a cell, in metres.
  int per_reference_cell = 1;  ///< Cells along a reference cell's edge; 0: no whole number.
  Pose2D corner_in_reference;  ///< Lower-left corner of cell (0, 0) in the reference map's frame.
};

/// The lattice for these maps; all of them have cells of positive size.
[[nodiscard]] Lattice chooseLattice(const std::vector<PlacedMap>& maps, std::size_t reference);

/// Pose of a map's grid (origin on its cell (0, 0)'s corner, metres) in the lattice's.
[[nodiscard]] Pose2D gridInLattice(const PlacedMap& map, const Lattice& lattice);

}  // namespace sbox
