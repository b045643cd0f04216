// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The "neighbourhood state difference" (paper, section 3.1.2): vertical points of extended lines
// that lie off the map's outline are dropped.
#pragma once

#include <vector>

#include "sbox/paper/point_clusters.h"

namespace sbox {

/// What counts as near the outline.
struct OutlineOptions {
  double reach = 1.0;  ///< How far to walk from the point in each of the four directions, metres.
};

/// Whether a walk from the point (grid frame, metres) along the rows and columns of the grid meets
/// a cell of another state than the point's own within the reach. Outside the grid all is unknown.
[[nodiscard]] bool nearOutline(const StateGrid& grid, const Point2D& point,
                               const OutlineOptions& options = {});

/// The clusters near the outline, in the same order.
[[nodiscard]] std::vector<PointCluster> filterByOutline(const StateGrid& grid,
                                                        const std::vector<PointCluster>& clusters,
                                                        const OutlineOptions& options = {});

}  // namespace sbox
