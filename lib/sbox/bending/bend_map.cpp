// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/bending/bend_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sbox/core/cell_corner.h"
#include "sbox/core/known_part.h"
#include "sbox/core/parallel.h"
#include "sbox/core/rigid_transform.h"
#include "sbox/fusion/cell_box.h"
#include "sbox/fusion/sub_cell_sampler.h"

namespace sbox {
namespace {

/// The lattice cells that what the placed map knows may reach once it is bent.
CellBox reachOf(const Map& map, const Pose2D& grid_in_lattice, double most_shift,
                const BentLattice& lattice) {
  double x_min = INFINITY, x_max = -INFINITY, y_min = INFINITY, y_max = -INFINITY;
  // A cell that is hardly free or hardly occupied is bent with the others.
  const KnownPart known = knownPart(map, StateLimits());
  const auto cornerAt = [&](int right, int up) {
    return grid_in_lattice.composePoint(Point2D(known.x_first + right * std::max(1, known.width),
                                                known.y_first + up * std::max(1, known.height)) *
                                        map.resolution());
  };
  for (const Point2D& p : {cornerAt(0, 0), cornerAt(1, 0), cornerAt(0, 1), cornerAt(1, 1)}) {
    x_min = std::min(x_min, p.x - most_shift);
    x_max = std::max(x_max, p.x + most_shift);
    y_min = std::min(y_min, p.y - most_shift);
    y_max = std::max(y_max, p.y + most_shift);
  }
  const double cells =
      (x_max - x_min) / lattice.resolution * ((y_max - y_min) / lattice.resolution);
  if (!(cells <= lattice.max_cells)) {
    throw std::length_error("map \"" + map.name + "\" is too large to be bent");
  }
  return {static_cast<int>(std::floor(x_min / lattice.resolution)),
          static_cast<int>(std::floor(y_min / lattice.resolution)),
          static_cast<int>(std::ceil(x_max / lattice.resolution)),
          static_cast<int>(std::ceil(y_max / lattice.resolution))};
}

std::int64_t toSubCells(double cells) {
  return std::llround(cells * static_cast<double>(kSubCellUnit));
}

}  // namespace

Map bendMap(const PlacedMap& placed, const Displacement& displacement, double most_shift,
            const BentLattice& lattice) {
  const Map& map = *placed.map;
  const Pose2D grid_in_reference = placed.pose_in_reference + map.corner_in_map;
  const Pose2D grid_in_lattice = inverse(lattice.corner_in_reference) + grid_in_reference;
  const CellBox box = reachOf(map, grid_in_lattice, most_shift, lattice);
  const Pose2D corner =
      cellCorner(lattice.corner_in_reference, lattice.resolution, box.x_first, box.y_first);
  Map bent = makeMap(map.name, box.x_end - box.x_first, box.y_end - box.y_first, lattice.resolution,
                     corner);
  const SubCellSampler sampler(
      map, neckWidth(grid_in_lattice.phi, std::min(1.0, lattice.resolution / map.resolution())));
  const PointMover to_grid(
      RigidTransform{grid_in_reference.phi, {grid_in_reference.x, grid_in_reference.y}}.inverse());
  parallelFor(bent.height(), lattice.threads, [&](int y) {
    CellLogOdds* row = bent.grid.getRow(y);
    for (int x = 0; x < bent.width(); ++x) {
      const Point2D here = bent.cellCentre(x, y);
      // Where it was before: the displacement there takes it here.
      Point2D before = here - displacement(here);
      before = here - displacement(before);
      const Eigen::Vector2d in_grid = to_grid({before.x, before.y});
      row[x] = static_cast<CellLogOdds>(sampler
                                            .at({toSubCells(in_grid.x() / map.resolution() - 0.5),
                                                 toSubCells(in_grid.y() / map.resolution() - 0.5)})
                                            .whole);
    }
  });
  return bent;
}

}  // namespace sbox
