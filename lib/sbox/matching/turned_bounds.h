// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sbox/features/map_features.h"

namespace sbox {

/// An upright rectangle, metres.
struct TurnedBounds {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();   ///< Lower-left corner.
  Eigen::Vector2d high = Eigen::Vector2d::Zero();  ///< Upper-right corner.
};

/// The least upright rectangle that holds the known part of a map once its grid frame is turned
/// about its origin by `angle` (radians).
[[nodiscard]] inline TurnedBounds turnedBounds(const MapFeatures& map, double angle) {
  const Eigen::Rotation2Dd turn(angle);
  TurnedBounds bounds;
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(map.width, 0), Eigen::Vector2d(0, map.height),
        Eigen::Vector2d(map.width, map.height)}) {
    const Eigen::Vector2d p = turn * corner;
    bounds.low = bounds.low.cwiseMin(p);
    bounds.high = bounds.high.cwiseMax(p);
  }
  return bounds;
}

}  // namespace sbox
