// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace sbox {

/// Lengths of wall, metres.
struct WallSums {
  double known = 0;     ///< Wall that agrees, or lies where the other map is free.
  double agree = 0;     ///< Wall on wall that faces the same way, weighed by the kernel.
  double conflict = 0;  ///< Wall in the other's free space, weighed by how deep.

  /// Adds to each.
  WallSums& operator+=(const WallSums& other) {
    known += other.known;
    agree += other.agree;
    conflict += other.conflict;
    return *this;
  }
};

/// The sums of both.
[[nodiscard]] inline WallSums operator+(WallSums left, const WallSums& right) {
  return left += right;
}

/// Each so many times.
[[nodiscard]] inline WallSums operator*(double factor, const WallSums& sums) {
  return {factor * sums.known, factor * sums.agree, factor * sums.conflict};
}

}  // namespace sbox
