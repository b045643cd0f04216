// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/align_to_axes.h"

#include <algorithm>
#include <cmath>

namespace sbox {

Map alignToAxes(const Map& map) {
  const double resolution = map.resolution();
  const double width = map.width() * resolution, height = map.height() * resolution;
  Point2D low = map.corner_in_map.composePoint({0, 0}), high = low;
  for (const Point2D& corner : {Point2D(width, 0), Point2D(0, height), Point2D(width, height)}) {
    const Point2D point = map.corner_in_map.composePoint(corner);
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  // A sliver of a cell from rounding is not a cell.
  const auto cells = [&](double length) {
    return std::max(1, static_cast<int>(std::ceil(length / resolution - 1e-6)));
  };
  Map aligned = makeMap(map.name, cells(high.x - low.x), cells(high.y - low.y), resolution,
                        {low.x, low.y, 0});
  for (int y = 0; y < aligned.height(); ++y) {
    auto* row = aligned.grid.getRow(y);
    for (int x = 0; x < aligned.width(); ++x) {
      const Point2D centre = map.corner_in_map.inverseComposePoint(aligned.cellCentre(x, y));
      const double cx = std::floor(centre.x / resolution);
      const double cy = std::floor(centre.y / resolution);
      if (cx >= 0 && cy >= 0 && cx < map.width() && cy < map.height()) {
        row[x] = map.grid.getRow(static_cast<int>(cy))[static_cast<int>(cx)];
      }
    }
  }
  return aligned;
}

}  // namespace sbox
