// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rounding to whole numbers in inner loops: where SSE 4.1 may not be taken for granted, as in a
// package for every x86-64, std::floor and std::ceil are calls of a function.
#pragma once

namespace sbox {

/// std::floor(value), for values that fit an int.
[[nodiscard]] inline int floorToInt(double value) {
  const int towards_zero = static_cast<int>(value);
  return towards_zero - (towards_zero > value ? 1 : 0);
}

/// std::ceil(value), for values that fit an int.
[[nodiscard]] inline int ceilToInt(double value) {
  const int towards_zero = static_cast<int>(value);
  return towards_zero + (towards_zero < value ? 1 : 0);
}

}  // namespace sbox
