// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace sbox {

/// A rectangle of cells, ends excluded; empty where an end is not behind its first.
struct CellBox {
  int x_first = 0;  ///< First column.
  int y_first = 0;  ///< First row.
  int x_end = 0;    ///< One beyond the last column.
  int y_end = 0;    ///< One beyond the last row.

  /// Whether it holds no cell.
  [[nodiscard]] bool empty() const { return x_end <= x_first || y_end <= y_first; }
};

/// The cells in both.
[[nodiscard]] inline CellBox intersection(const CellBox& a, const CellBox& b) {
  return {std::max(a.x_first, b.x_first), std::max(a.y_first, b.y_first),
          std::min(a.x_end, b.x_end), std::min(a.y_end, b.y_end)};
}

/// The least rectangle that holds both.
[[nodiscard]] inline CellBox hull(const CellBox& a, const CellBox& b) {
  if (a.empty() || b.empty()) {
    return a.empty() ? b : a;
  }
  return {std::min(a.x_first, b.x_first), std::min(a.y_first, b.y_first),
          std::max(a.x_end, b.x_end), std::max(a.y_end, b.y_end)};
}

}  // namespace sbox
