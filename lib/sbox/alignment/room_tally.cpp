// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/alignment/room_tally.h"

#include <algorithm>
#include <cmath>

namespace sbox {
namespace {

constexpr double kSide = 6;       // Of a square, metres.
constexpr double kLeastWall = 2;  // Of wall that a square must have in common to count, metres.
/// Walls of a square do not fit if less of what is known agrees, ...
constexpr double kLeastAgree = 0.4;
/// ... or more of it conflicts.
constexpr double kMostConflict = 0.3;

size_t squaresAlong(double length) {
  // Half a square before, and what is left over behind.
  return static_cast<size_t>(std::ceil(std::max(length, 0.0) / kSide)) + 1;
}

}  // namespace

RoomTally::RoomTally(const Eigen::Vector2d& low, const Eigen::Vector2d& high)
    : low_(low),
      columns_(squaresAlong(high.x() - low.x())),
      rows_(squaresAlong(high.y() - low.y())) {
  for (std::vector<WallSums>& squares : lattices_) {
    squares.resize(columns_ * rows_);
  }
}

void RoomTally::add(const Eigen::Vector2d& place, const WallSums& wall) {
  const double x = (place.x() - low_.x()) / kSide, y = (place.y() - low_.y()) / kSide;
  for (size_t i = 0; i < lattices_.size(); ++i) {
    const auto column = static_cast<size_t>(std::max(0.0, x + (i % 2 == 0 ? 0 : 0.5)));
    const auto row = static_cast<size_t>(std::max(0.0, y + (i < 2 ? 0 : 0.5)));
    lattices_[i][std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1)] += wall;
  }
}

RoomCounts RoomTally::counts() const {
  RoomCounts counts;
  const double share = 1 / static_cast<double>(lattices_.size());
  for (const std::vector<WallSums>& squares : lattices_) {
    for (const WallSums& wall : squares) {
      if (wall.known < kLeastWall) {
        continue;
      }
      counts.all += share;
      if (wall.agree < kLeastAgree * wall.known || wall.conflict > kMostConflict * wall.known) {
        counts.misfit += share;
      }
    }
  }
  return counts;
}

}  // namespace sbox
