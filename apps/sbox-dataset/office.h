// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random offices: rooms of all sizes on both sides of a corridor, with doors, furniture, a hall
// here and there and corners cut off.
#pragma once

#include <cstdint>

#include "sbox-dataset/world.h"

namespace sbox::dataset {

struct OfficeOptions {
  double least_length = 24;       ///< Of the building, metres.
  double most_length = 36;        ///< Of the building, metres.
  double least_room = 2.8;        ///< Width of a room along the corridor, metres.
  double most_room = 6.5;         ///< Width of a room along the corridor, metres.
  double least_depth = 4;         ///< Depth of a row of rooms, metres.
  double most_depth = 6.5;        ///< Depth of a row of rooms, metres.
  double furniture_per_m2 = 0.1;  ///< Pieces.
};

/// The office of this seed. Its places are one a room, and some along the corridor.
[[nodiscard]] World randomOffice(std::uint32_t seed, const OfficeOptions& options = {});

}  // namespace sbox::dataset
