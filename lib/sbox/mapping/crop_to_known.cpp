// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/mapping/crop_to_known.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/state_grid.h"

namespace sbox {

Map cropToKnown(const Map& map) {
  // Anything but exactly unknown is worth keeping.
  const StateGrid known = classifyCells(map, {0.505, 0.495});
  Map cropped = makeMap(map.name, known.width, known.height, known.resolution, known.corner_in_map);
  const auto x_first = static_cast<int>(
      std::lround((known.corner_in_map.x - map.corner_in_map.x) / known.resolution));
  const auto y_first = static_cast<int>(
      std::lround((known.corner_in_map.y - map.corner_in_map.y) / known.resolution));
  for (int y = 0; y < known.height; ++y) {
    const auto* row = map.grid.getRow(y + y_first) + x_first;
    std::copy(row, row + known.width, cropped.grid.getRow(y));
  }
  return cropped;
}

}  // namespace sbox
