// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/fusion/lattice.h"

#include <algorithm>
#include <cmath>

namespace sbox {
namespace {

/// MRPT keeps cell sizes as floats, so equal ones may differ in the seventh digit.
constexpr double kSizeTolerance = 1e-5;

}  // namespace

Lattice chooseLattice(const std::vector<PlacedMap>& maps, std::size_t reference) {
  const Map& reference_map = *maps[reference].map;
  Lattice lattice;
  lattice.corner_in_reference = reference_map.corner_in_map;
  double finest = reference_map.resolution();
  for (const PlacedMap& placed : maps) {
    finest = std::min(finest, placed.map->resolution());
  }
  const double ratio = reference_map.resolution() / finest;
  const double whole = std::round(ratio);
  if (std::abs(ratio - whole) <= kSizeTolerance * whole) {
    lattice.per_reference_cell = static_cast<int>(whole);
    lattice.resolution = reference_map.resolution() / whole;
  } else {
    lattice.per_reference_cell = 0;
    lattice.resolution = finest;
  }
  return lattice;
}

Pose2D gridInLattice(const PlacedMap& map, const Lattice& lattice) {
  return inverse(lattice.corner_in_reference) + (map.pose_in_reference + map.map->corner_in_map);
}

}  // namespace sbox
