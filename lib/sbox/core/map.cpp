// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/map.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace sbox {

Point2D Map::cellCentre(int cx, int cy) const {
  return corner_in_map.composePoint({(cx + 0.5) * resolution(), (cy + 0.5) * resolution()});
}

Map makeMap(std::string name, int width, int height, double resolution,
            const Pose2D& corner_in_map) {
  if (width < 1 || height < 1 || !std::isfinite(resolution) || resolution <= 0) {
    throw std::invalid_argument("a map needs at least one cell and a positive cell size");
  }
  Map map;
  map.name = std::move(name);
  map.corner_in_map = corner_in_map;
  // Extents about zero: floats far from it would make MRPT miscount the cells.
  const auto cell = static_cast<float>(resolution);
  map.grid.setSize(0, cell * static_cast<float>(width), 0, cell * static_cast<float>(height), cell,
                   0.5F);
  if (map.width() != width || map.height() != height) {
    throw std::logic_error("MRPT made a grid of another size than asked for");
  }
  return map;
}

}  // namespace sbox
