// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/outline_filter.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sbox {

bool nearOutline(const StateGrid& grid, const Point2D& point, const OutlineOptions& options) {
  if (grid.empty()) {
    return false;
  }
  // Far off the grid nothing differs; it also keeps the cell number within an int.
  const double width = grid.width * grid.resolution, height = grid.height * grid.resolution;
  if (point.x < -options.reach || point.y < -options.reach || point.x > width + options.reach ||
      point.y > height + options.reach) {
    return false;
  }
  const int x = static_cast<int>(std::floor(point.x / grid.resolution));
  const int y = static_cast<int>(std::floor(point.y / grid.resolution));
  const int steps = static_cast<int>(
      std::min(std::floor(options.reach / grid.resolution + 1e-9), 1.0 * grid.width + grid.height));
  const CellState own = grid.at(x, y);
  for (int i = 1; i <= steps; ++i) {
    if (grid.at(x + i, y) != own || grid.at(x - i, y) != own || grid.at(x, y + i) != own ||
        grid.at(x, y - i) != own) {
      return true;
    }
  }
  return false;
}

std::vector<PointCluster> filterByOutline(const StateGrid& grid,
                                          const std::vector<PointCluster>& clusters,
                                          const OutlineOptions& options) {
  std::vector<PointCluster> kept;
  std::copy_if(
      clusters.begin(), clusters.end(), std::back_inserter(kept),
      [&](const PointCluster& cluster) { return nearOutline(grid, cluster.position, options); });
  return kept;
}

}  // namespace sbox
