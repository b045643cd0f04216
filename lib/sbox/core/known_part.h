// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a map's known cells are, without a copy of the map.
#pragma once

#include "sbox/core/state_limits.h"

namespace sbox {

/// The least rectangle that holds all known cells of a map; of no width if there are none.
struct KnownPart {
  int x_first = 0;  ///< Its first column.
  int y_first = 0;  ///< Its first row.
  int width = 0;    ///< Its columns.
  int height = 0;   ///< Its rows.
};

/// The known part of a map, by these limits.
[[nodiscard]] KnownPart knownPart(const Map& map, const StateLimits& limits);

/// Lower-left corner of the part, in the map frame, along the grid's axes.
[[nodiscard]] Pose2D cornerInMap(const Map& map, const KnownPart& part);

}  // namespace sbox
