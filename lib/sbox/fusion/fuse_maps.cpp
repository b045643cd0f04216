// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/fusion/fuse_maps.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sbox/core/cell_corner.h"
#include "sbox/core/parallel.h"
#include "sbox/fusion/contested_cell.h"
#include "sbox/fusion/evidence_tile.h"
#include "sbox/fusion/lattice.h"
#include "sbox/fusion/log_odds_rule.h"
#include "sbox/fusion/map_layer.h"
#include "sbox/fusion/table_rule.h"

namespace sbox {
namespace {

/// Edge of a tile, in cells: 128 x 64 cells of evidence fit a core's second-level cache.
constexpr int kTileWidth = 128, kTileHeight = 64;

void checkInput(const std::vector<PlacedMap>& maps, std::size_t reference) {
  if (reference >= maps.size()) {
    throw std::invalid_argument("fuseMaps needs a reference among its maps");
  }
  for (const PlacedMap& placed : maps) {
    if (placed.map == nullptr || placed.map->width() < 1 || placed.map->height() < 1) {
      throw std::invalid_argument("fuseMaps was given a map without cells");
    }
    const Pose2D& pose = placed.pose_in_reference;
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.phi)) {
      throw std::invalid_argument("fuseMaps was given a pose that is not finite");
    }
  }
}

void checkSize(const CellBox& box, double max_cells) {
  const double width = static_cast<double>(box.x_end) - box.x_first;
  const double height = static_cast<double>(box.y_end) - box.y_first;
  if (width * height > max_cells) {
    throw std::length_error("the merged map would have " + std::to_string(std::llround(width)) +
                            " x " + std::to_string(std::llround(height)) +
                            " cells, more than allowed");
  }
}

Map makeMerged(const Lattice& lattice, const CellBox& box) {
  return makeMap(
      "merged", box.x_end - box.x_first, box.y_end - box.y_first, lattice.resolution,
      cellCorner(lattice.corner_in_reference, lattice.resolution, box.x_first, box.y_first));
}

/// What lies in a band of rows.
struct Shared {
  std::size_t cells = 0;               ///< As FusionResult::shared_cells.
  std::vector<std::size_t> conflicts;  ///< As FusionResult's, but tile by tile.
};

int saturated(int log_odds) { return std::clamp(log_odds, -127, 127); }

/// What settleUncontested() finds in a row.
struct RowCounts {
  std::uint32_t shared = 0, contested = 0;
};

/// Settles the cells of a row of a tile, those that are contested as if they were not. Without a
/// branch, so that compilers work on many cells at once.
RowCounts settleUncontested(const CellTally* tallies, std::size_t count, CellLogOdds* out) {
  RowCounts counts;
  for (std::size_t i = 0; i < count; ++i) {
    const CellTally tally = tallies[i];
    out[i] = static_cast<CellLogOdds>(saturated(tally.free() - tally.occupied()));
    counts.shared += static_cast<std::uint32_t>(tally.maps() >= 2);
    counts.contested += static_cast<std::uint32_t>(tally.contested());
  }
  return counts;
}

/// Settles the cells of a tile and writes them into `merged`, whose cell (0, 0) is lattice cell
/// (box.x_first, box.y_first). Adds to what is shared and in conflict.
void settleTile(const EvidenceTile& tile, const std::vector<MapLayer>& layers, const CellBox& box,
                const FusionOptions& options, const StateLimits& limits, Map* merged,
                Shared* shared) {
  const CellBox& cells = tile.cells();
  const auto count = static_cast<std::size_t>(cells.x_end - cells.x_first);
  const auto column = static_cast<std::size_t>(cells.x_first - box.x_first);
  for (int y = cells.y_first; y < cells.y_end; ++y) {
    const CellTally* tallies = tile.row(y);
    const int row = y - box.y_first;
    CellLogOdds* out = merged->grid.getRow(row) + column;
    const RowCounts counts = settleUncontested(tallies, count, out);
    shared->cells += counts.shared;
    if (counts.contested == 0) {
      continue;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!tallies[i].contested()) {
        continue;
      }
      const ContestedCell cell =
          contestedCell(layers, cells.x_first + static_cast<int>(i), y, limits);
      out[i] = static_cast<CellLogOdds>(saturated(
          options.rule == FusionRule::Table ? settleByTable(cell, limits) : settleByLogOdds(cell)));
      if (cell.conflict) {
        shared->conflicts.push_back(
            static_cast<std::size_t>(row) * static_cast<std::size_t>(merged->width()) + column + i);
      }
    }
  }
}

}  // namespace

FusionResult fuseMaps(const std::vector<PlacedMap>& maps, std::size_t reference,
                      const FusionOptions& options) {
  checkInput(maps, reference);
  const Lattice lattice = chooseLattice(maps, reference);
  std::vector<MapLayer> layers;
  CellBox box;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    layers.push_back(layMap(maps[i], lattice, i == reference));
    box = hull(box, layers.back().box);
  }
  if (box.empty()) {
    box = {0, 0, 1, 1};
  }
  checkSize(box, options.max_cells);

  FusionResult result;
  result.merged = makeMerged(lattice, box);
  const StateLimits limits = stateLimits(options.states);
  const int bands = (result.merged.height() + kTileHeight - 1) / kTileHeight;
  std::vector<Shared> shared(static_cast<std::size_t>(bands));
  parallelFor(bands, options.threads, [&](int band) {
    EvidenceTile tile;
    CellBox cells = box;
    cells.y_first = box.y_first + band * kTileHeight;
    cells.y_end = std::min(cells.y_first + kTileHeight, box.y_end);
    for (int x = box.x_first; x < box.x_end; x += kTileWidth) {
      cells.x_first = x;
      cells.x_end = std::min(x + kTileWidth, box.x_end);
      tile.reset(cells);
      bool any_known = false;
      for (const MapLayer& layer : layers) {
        any_known = tile.add(layer) || any_known;
      }
      if (any_known) {
        settleTile(tile, layers, box, options, limits, &result.merged,
                   &shared[static_cast<std::size_t>(band)]);
      }
    }
  });
  for (Shared& in_band : shared) {
    std::sort(in_band.conflicts.begin(), in_band.conflicts.end());
    result.shared_cells += in_band.cells;
    result.conflicts.insert(result.conflicts.end(), in_band.conflicts.begin(),
                            in_band.conflicts.end());
  }
  if (result.shared_cells > 0) {
    result.conflict_share =
        static_cast<double>(result.conflicts.size()) / static_cast<double>(result.shared_cells);
  }
  return result;
}

}  // namespace sbox
