// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "sbox/core/map.h"
#include "sbox/fusion/placed_map.h"

namespace sbox {

/// The displacement of what the pose of a map puts at a point of the reference frame; metres.
using Displacement = std::function<Point2D(const Point2D& in_reference)>;

/// Where and how finely a bent map is drawn.
struct BentLattice {
  Pose2D corner_in_reference;  ///< Lower-left corner of a cell; phi turns the rows.
  double resolution = 0;       ///< Edge length of a cell, metres.
  double max_cells = 4e8;      ///< A bent map with more cells than this is refused.
  int threads = 1;             ///< 0: one a core. The result does not depend on it.
};

/// The map in the reference frame, on that lattice, each cell moved by its pose and then by the
/// displacement, which changes slowly (a small part of itself within its own length) and is at most
/// `most_shift` metres. Sampled as fuseMaps does, by inverse warping: no holes, no thicker walls.
/// Throws std::length_error above max_cells.
[[nodiscard]] Map bendMap(const PlacedMap& placed, const Displacement& displacement,
                          double most_shift, const BentLattice& lattice);

}  // namespace sbox
