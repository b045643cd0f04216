// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Looks many points of one map up in the fields of another. Fields are larger than the caches next
// to a core, and where each point falls is hard to foresee: batch by batch all places are worked
// out before the first cell is read, so that memory serves them side by side.
#pragma once

#include <algorithm>
#include <array>

#include "sbox/features/wall_fields.h"

namespace sbox {

/// Calls take(i, place, cell) for each i below `count` whose place place_of(i), in the fields' grid
/// frame, lies on the fields, as WallFields::cellAt() tells; in order.
template <typename PlaceOf, typename Take>
void forEachCell(const WallFields& fields, size_t count, const PlaceOf& place_of,
                 const Take& take) {
  struct Found {
    Eigen::Vector2d place;
    size_t point, cell;
  };
  std::array<Found, 128> batch;
  const Eigen::Array2d size(fields.width, fields.height);
  const Eigen::Array2d last_cell = size - 1;
  const auto stride = static_cast<size_t>(fields.width);
  for (size_t first = 0; first < count && stride > 0; first += batch.size()) {
    const size_t last = std::min(count, first + batch.size());
    size_t found = 0;
    for (size_t i = first; i < last; ++i) {
      const Eigen::Vector2d place = place_of(i);
      const Eigen::Array2d at = ((place - fields.origin) / fields.resolution).array();
      // No branches: which points lie outside cannot be foreseen either.
      const Eigen::Array2d within = at.max(0.0).min(last_cell);
      batch[found] = {place, i,
                      static_cast<size_t>(within.y()) * stride + static_cast<size_t>(within.x())};
      found += static_cast<size_t>(static_cast<int>(at.x() >= 0) & static_cast<int>(at.y() >= 0) &
                                   static_cast<int>(at.x() < size.x()) &
                                   static_cast<int>(at.y() < size.y()));
    }
    for (size_t k = 0; k < found; ++k) {
      take(batch[k].point, batch[k].place, batch[k].cell);
    }
  }
}

/// Calls take(i, distance, depth) with what the fields hold at the place place_of(i) of each i
/// below `count`, for walls that face the sector of direction_of(i); those beside the fields are
/// left out. In order.
template <typename PlaceOf, typename DirectionOf, typename Take>
void forEachField(const WallFields& fields, size_t count, const PlaceOf& place_of,
                  const DirectionOf& direction_of, const Take& take) {
  struct Found {
    size_t point;
    std::uint8_t distance, depth;
  };
  std::array<Found, 128> batch;
  size_t found = 0;
  const auto takeAll = [&] {
    for (size_t k = 0; k < found; ++k) {
      take(batch[k].point, batch[k].distance, batch[k].depth);
    }
    found = 0;
  };
  forEachCell(fields, count, place_of, [&](size_t i, const Eigen::Vector2d&, size_t cell) {
    batch[found++] = {i, fields.distances[sectorOf(direction_of(i))][cell],
                      fields.free_depth[cell]};
    if (found == batch.size()) {
      takeAll();
    }
  });
  takeAll();
}

/// Calls take(i, place, nearest) for each i below `count` that has a wall point within reach of its
/// place place_of(i), in the fields' grid frame, which faces the sector of direction_of(i);
/// `nearest` is the index of that wall point. In order.
template <typename PlaceOf, typename DirectionOf, typename Take>
void forEachNearest(const WallFields& fields, size_t count, const PlaceOf& place_of,
                    const DirectionOf& direction_of, const Take& take) {
  struct Found {
    Eigen::Vector2d place;
    size_t point;
    std::int32_t nearest;
  };
  std::array<Found, 128> batch;
  size_t found = 0;
  const auto takeAll = [&] {
    for (size_t k = 0; k < found; ++k) {
      take(batch[k].point, batch[k].place, static_cast<size_t>(batch[k].nearest));
    }
    found = 0;
  };
  forEachCell(fields, count, place_of, [&](size_t i, const Eigen::Vector2d& place, size_t cell) {
    const std::int32_t nearest = fields.nearest[sectorOf(direction_of(i))][cell];
    batch[found] = {place, i, nearest};
    found += nearest >= 0 ? 1 : 0;
    if (found == batch.size()) {
      takeAll();
    }
  });
  takeAll();
}

}  // namespace sbox
