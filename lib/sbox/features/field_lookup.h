// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Looks many points of one map up in the fields of another. Fields are larger than the caches next
// to a core, and where each point falls is hard to foresee: batch by batch all places are worked
// out, and their memory asked for, before the first cell is read.
#pragma once

#include <algorithm>
#include <array>

#include "sbox/features/wall_fields.h"

namespace sbox {

/// Calls take(i, place, cell) for each i below `count` whose place place_of(i), in the fields' grid
/// frame, lies on the fields, as WallFields::cellAt() tells; in order. What take() will read of the
/// fields is at the addresses addresses_of(i, cell).
template <typename PlaceOf, typename AddressesOf, typename Take>
void forEachCell(const WallFields& fields, size_t count, const PlaceOf& place_of,
                 const AddressesOf& addresses_of, const Take& take) {
  struct Found {
    Eigen::Vector2d place;
    size_t point, cell;
  };
  std::array<Found, 128> batch;
  // With a rim of one cell, in which all that lies outside is found.
  const Eigen::Array2d rim(fields.width + 1, fields.height + 1);
  const Eigen::Vector2d origin = fields.origin - Eigen::Vector2d::Constant(fields.resolution);
  const double per_cell = 1 / fields.resolution;
  const auto width = static_cast<unsigned>(fields.width);
  const auto height = static_cast<unsigned>(fields.height);
  const auto stride = static_cast<size_t>(fields.width);
  for (size_t first = 0; first < count && stride > 0; first += batch.size()) {
    const size_t last = std::min(count, first + batch.size());
    size_t found = 0;
    for (size_t i = first; i < last; ++i) {
      const Eigen::Vector2d place = place_of(i);
      const Eigen::Array2d at = ((place - origin) * per_cell).array().max(0.0).min(rim);
      const unsigned column = static_cast<unsigned>(static_cast<int>(at.x())) - 1;
      const unsigned row = static_cast<unsigned>(static_cast<int>(at.y())) - 1;
      // No branches: which points lie outside cannot be foreseen either.
      const bool inside = (column < width) & (row < height);
      const size_t cell = inside ? row * stride + column : 0;
      for (const void* address : addresses_of(i, cell)) {
        __builtin_prefetch(address);
      }
      batch[found] = {place, i, cell};
      found += inside ? 1 : 0;
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
  const auto addressesOf = [&](size_t i, size_t cell) {
    return std::array<const std::uint8_t*, 2>{
        fields.distances[sectorOf(direction_of(i))].data() + cell, fields.free_depth.data() + cell};
  };
  forEachCell(fields, count, place_of, addressesOf,
              [&](size_t i, const Eigen::Vector2d&, size_t cell) {
                const auto [distance, depth] = addressesOf(i, cell);
                take(i, *distance, *depth);
              });
}

/// Calls take(i, depth) with what `free_depth` holds at the place place_of(i) of each i below
/// `count`; those beside the fields are left out. In order.
template <typename PlaceOf, typename Take>
void forEachDepth(const WallFields& fields, size_t count, const PlaceOf& place_of,
                  const Take& take) {
  const auto addressesOf = [&](size_t, size_t cell) {
    return std::array<const std::uint8_t*, 1>{fields.free_depth.data() + cell};
  };
  forEachCell(
      fields, count, place_of, addressesOf,
      [&](size_t i, const Eigen::Vector2d&, size_t cell) { take(i, fields.free_depth[cell]); });
}

/// Calls take(i, place, nearest) for each i below `count` that has one of the fields' wall points
/// `points` within reach of its place place_of(i), in the fields' grid frame, which faces the
/// sector of direction_of(i); `nearest` is that wall point. In order.
template <typename PlaceOf, typename DirectionOf, typename Take>
void forEachNearest(const WallFields& fields, const std::vector<WallPoint>& points, size_t count,
                    const PlaceOf& place_of, const DirectionOf& direction_of, const Take& take) {
  struct Found {
    Eigen::Vector2d place;
    size_t point;
    const WallPoint* nearest;
  };
  std::array<Found, 128> batch;
  size_t found = 0;
  const auto takeAll = [&] {
    for (size_t k = 0; k < found; ++k) {
      take(batch[k].point, batch[k].place, *batch[k].nearest);
    }
    found = 0;
  };
  const auto addressesOf = [&](size_t i, size_t cell) {
    return std::array<const std::uint16_t*, 1>{fields.nearest[sectorOf(direction_of(i))].data() +
                                               cell};
  };
  forEachCell(fields, count, place_of, addressesOf,
              [&](size_t i, const Eigen::Vector2d& place, size_t cell) {
                const std::uint16_t index = *addressesOf(i, cell)[0];
                const WallPoint* nearest = points.data() + std::min<size_t>(index, points.size());
                __builtin_prefetch(nearest);
                batch[found] = {place, i, nearest};
                found += index != WallFields::none ? 1 : 0;
                if (found == batch.size()) {
                  takeAll();
                }
              });
  takeAll();
}

}  // namespace sbox
