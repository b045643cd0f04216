// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/fusion/evidence_tile.h"

namespace sbox {

void EvidenceTile::reset(const CellBox& cells) {
  cells_ = cells;
  tallies_.assign(width() * static_cast<std::size_t>(cells.y_end - cells.y_first), {});
}

bool EvidenceTile::add(const MapLayer& layer) {
  const CellBox cells = intersection(cells_, layer.box);
  if (cells.empty()) {
    return false;
  }
  if (layer.lattice_cells_per_cell > 0) {
    addAsIs(layer, cells);
  } else {
    addWarped(layer, cells);
  }
  return true;
}

void EvidenceTile::addAsIs(const MapLayer& layer, const CellBox& cells) {
  const int per_cell = layer.lattice_cells_per_cell;
  for (int y = cells.y_first; y < cells.y_end; ++y) {
    const CellLogOdds* from = layer.map->grid.getRow(y / per_cell) + cells.x_first / per_cell;
    int left = per_cell - cells.x_first % per_cell;
    CellTally* to = cell(cells.x_first, y);
    for (int x = cells.x_first; x < cells.x_end; ++x) {
      (to++)->add(*from);
      if (--left == 0) {
        left = per_cell;
        ++from;
      }
    }
  }
}

void EvidenceTile::addWarped(const MapLayer& layer, const CellBox& cells) {
  const SubCellSampler& sampler = layer.sampler;
  const SubCell step = layer.warp.stepX();
  for (int y = cells.y_first; y < cells.y_end; ++y) {
    const CellSpan reach = layer.warp.spanWithin({cells.x_first, cells.x_end}, y,
                                                 SubCellSampler::reachLow(), sampler.reachHigh());
    const CellSpan inside =
        layer.warp.spanWithin(reach, y, SubCellSampler::insideLow(), sampler.insideHigh());
    SubCell place = layer.warp.at(reach.first, y);
    CellTally* to = cell(reach.first, y);
    const auto walk = [&](int count, const auto& sample) {
      for (int i = 0; i < count; ++i, place.u += step.u, place.v += step.v) {
        (to++)->add(sample(place));
      }
    };
    walk(inside.first - reach.first, [&](const SubCell& at) { return sampler.at(at).whole; });
    walk(inside.end - inside.first, [&](const SubCell& at) { return sampler.wholeInside(at); });
    walk(reach.end - inside.end, [&](const SubCell& at) { return sampler.at(at).whole; });
  }
}

}  // namespace sbox
