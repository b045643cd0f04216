// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/core/map.h"

namespace sbox {

/// A map and where it goes; it does not own the map.
struct PlacedMap {
  const Map* map = nullptr;  ///< Not owned.
  Pose2D pose_in_reference;  ///< Frame of the map in the frame of the reference map.
};

}  // namespace sbox
