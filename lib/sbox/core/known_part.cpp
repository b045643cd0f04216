// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/known_part.h"

#include <algorithm>

#include "sbox/core/cell_corner.h"

namespace sbox {
namespace {

/// Looks at each cell, without a branch: most of what is asked about is unknown throughout.
bool anyKnown(const CellLogOdds* first, const CellLogOdds* last, StateLimits limits) {
  unsigned char any = 0;
  for (; first != last; ++first) {
    any |= static_cast<unsigned char>(limits.knows(*first));
  }
  return any != 0;
}

}  // namespace

KnownPart knownPart(const Map& map, const StateLimits& limits) {
  const auto known = [&](CellLogOdds cell) { return limits.knows(cell); };
  const auto is_known_row = [&](int y) {
    const CellLogOdds* row = map.grid.getRow(y);
    return anyKnown(row, row + map.width(), limits);
  };
  int y_first = 0, y_last = map.height() - 1;
  while (y_first <= y_last && !is_known_row(y_first)) {
    ++y_first;
  }
  while (y_last > y_first && !is_known_row(y_last)) {
    --y_last;
  }
  if (y_first > y_last) {
    return {};
  }
  int x_first = map.width(), x_last = -1;
  for (int y = y_first; y <= y_last; ++y) {
    const CellLogOdds* row = map.grid.getRow(y);
    const CellLogOdds* end = row + map.width();
    if (anyKnown(row, row + x_first, limits)) {
      x_first = static_cast<int>(std::find_if(row, end, known) - row);
    }
    if (anyKnown(row + x_last + 1, end, limits)) {
      x_last = map.width() - 1;
      while (!known(row[x_last])) {
        --x_last;
      }
    }
  }
  return {x_first, y_first, x_last - x_first + 1, y_last - y_first + 1};
}

Pose2D cornerInMap(const Map& map, const KnownPart& part) {
  return cellCorner(map.corner_in_map, map.resolution(), part.x_first, part.y_first);
}

}  // namespace sbox
