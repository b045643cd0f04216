// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/fusion/contested_cell.h"

#include <algorithm>

namespace sbox {
namespace {

bool occupiedAround(const SubCellSampler& sampler, const SubCell& place, int occupied_to) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (sampler.nearest(place, dx, dy) <= occupied_to) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

ContestedCell contestedCell(const std::vector<MapLayer>& layers, int x, int y,
                            const StateLimits& limits) {
  ContestedCell cell;
  bool any_open = false;
  for (const MapLayer& layer : layers) {
    const CellEvidence evidence = layer.at(x, y);
    cell.net_free += std::max(evidence.net, 0);
    cell.net_occupied += std::min(evidence.net, 0);
    cell.most_free = std::max(cell.most_free, evidence.whole);
    cell.most_occupied = std::min(cell.most_occupied, evidence.whole);
    any_open =
        any_open || (evidence.whole >= limits.free_from &&
                     !occupiedAround(layer.sampler, layer.warp.at(x, y), limits.occupied_to));
  }
  cell.conflict = any_open && cell.most_occupied <= limits.occupied_to;
  return cell;
}

}  // namespace sbox
