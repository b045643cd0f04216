// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the walls that do not fit lie together. Under a right transform they do: a room was
// rebuilt, a wing was carried off by drift, and the rest fits. Under a wrong one they are strewn
// all over.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sbox/alignment/wall_sums.h"

namespace sbox {

/// Squares the size of a room.
struct RoomCounts {
  double all = 0;     ///< Those with walls in common.
  double misfit = 0;  ///< Those of them whose walls do not fit.
};

/// Sums walls up by squares. Where the squares begin is arbitrary, so that there are four lattices
/// of them, half a square apart; what is counted is the mean.
class RoomTally {
 public:
  /// Over a rectangle from `low` to `high`, metres.
  RoomTally(const Eigen::Vector2d& low, const Eigen::Vector2d& high);
  /// Adds wall at a place; one beyond the rectangle counts to the nearest square.
  void add(const Eigen::Vector2d& place, const WallSums& wall);
  /// Of the squares with some wall.
  [[nodiscard]] RoomCounts counts() const;

 private:
  Eigen::Vector2d low_;
  size_t columns_, rows_;
  std::array<std::vector<WallSums>, 4> lattices_;
};

}  // namespace sbox
