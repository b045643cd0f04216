// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/fusion/map_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sbox {
namespace {

/// Known cells as seen along the lattice's axes, in lattice cells.
struct Extent {
  double x_min = std::numeric_limits<double>::infinity();
  double x_max = -std::numeric_limits<double>::infinity();
  double y_min = std::numeric_limits<double>::infinity();
  double y_max = -std::numeric_limits<double>::infinity();

  void add(const Point2D& point, double resolution) {
    x_min = std::min(x_min, point.x / resolution);
    x_max = std::max(x_max, point.x / resolution);
    y_min = std::min(y_min, point.y / resolution);
    y_max = std::max(y_max, point.y / resolution);
  }
};

/// Extent of the corners of all known cells; the first and the last of each row are enough.
Extent knownExtent(const Map& map, const Pose2D& grid_in_lattice, double lattice_resolution) {
  const double cell = map.resolution();
  const auto known = [](CellLogOdds value) { return value != 0; };
  Extent extent;
  for (int y = 0; y < map.height(); ++y) {
    const CellLogOdds* row = map.grid.getRow(y);
    const CellLogOdds* end = row + map.width();
    const CellLogOdds* first = std::find_if(row, end, known);
    if (first == end) {
      continue;
    }
    while (!known(end[-1])) {
      --end;
    }
    for (const auto x : {first - row, end - row}) {
      for (const int corner_y : {y, y + 1}) {
        extent.add(grid_in_lattice.composePoint({static_cast<double>(x) * cell, corner_y * cell}),
                   lattice_resolution);
      }
    }
  }
  return extent;
}

bool knowsAny(const MapLayer& layer, const CellBox& cells) {
  for (int y = cells.y_first; y < cells.y_end; ++y) {
    for (int x = cells.x_first; x < cells.x_end; ++x) {
      if (layer.at(x, y).whole != 0) {
        return true;
      }
    }
  }
  return false;
}

/// Takes off outer rows and columns at which no cell centre falls on something known.
CellBox shrinkToKnown(const MapLayer& layer, CellBox box) {
  while (!box.empty() && !knowsAny(layer, {box.x_first, box.y_first, box.x_end, box.y_first + 1})) {
    ++box.y_first;
  }
  while (!box.empty() && !knowsAny(layer, {box.x_first, box.y_end - 1, box.x_end, box.y_end})) {
    --box.y_end;
  }
  while (!box.empty() && !knowsAny(layer, {box.x_first, box.y_first, box.x_first + 1, box.y_end})) {
    ++box.x_first;
  }
  while (!box.empty() && !knowsAny(layer, {box.x_end - 1, box.y_first, box.x_end, box.y_end})) {
    --box.x_end;
  }
  return box;
}

}  // namespace

CellEvidence MapLayer::at(int x, int y) const {
  if (lattice_cells_per_cell == 0) {
    return sampler.at(warp.at(x, y));
  }
  const int value = sampler.nearest(warp.at(x, y));
  return {value, value};
}

MapLayer layMap(const PlacedMap& placed, const Lattice& lattice, bool is_reference) {
  const Map& map = *placed.map;
  const Pose2D grid_in_lattice = is_reference ? Pose2D() : gridInLattice(placed, lattice);
  const Extent extent = knownExtent(map, grid_in_lattice, lattice.resolution);
  constexpr double kLimit = 1 << 30;
  const bool anything = extent.x_min <= extent.x_max;
  if (anything && !(extent.x_min > -kLimit && extent.x_max < kLimit && extent.y_min > -kLimit &&
                    extent.y_max < kLimit)) {
    throw std::length_error("map \"" + map.name +
                            "\" lies too far from the reference map to merge");
  }
  const double angle = anything ? grid_in_lattice.phi : 0;
  MapLayer layer{
      CellWarp(anything ? grid_in_lattice : Pose2D(), map.resolution(), lattice.resolution),
      SubCellSampler(map, neckWidth(angle, lattice.resolution / map.resolution())),
      {},
      is_reference ? lattice.per_reference_cell : 0,
      &map};
  if (anything) {
    layer.box = shrinkToKnown(
        layer,
        {static_cast<int>(std::floor(extent.x_min)), static_cast<int>(std::floor(extent.y_min)),
         static_cast<int>(std::ceil(extent.x_max)), static_cast<int>(std::ceil(extent.y_max))});
  }
  return layer;
}

}  // namespace sbox
