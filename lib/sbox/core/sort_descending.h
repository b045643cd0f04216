// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace sbox {

/// Indices of `keys`, that of the largest first; those of equal keys ascend.
[[nodiscard]] std::vector<size_t> descendingOrder(const std::vector<double>& keys);

/// Sorts by the number key(value), the largest first; values of equal keys stay in order.
template <typename Value, typename Key>
void sortDescending(std::vector<Value>& values, const Key& key) {
  std::vector<double> keys;
  keys.reserve(values.size());
  for (const Value& value : values) {
    keys.push_back(key(value));
  }
  std::vector<Value> sorted;
  sorted.reserve(values.size());
  for (const size_t i : descendingOrder(keys)) {
    sorted.push_back(std::move(values[i]));
  }
  values = std::move(sorted);
}

}  // namespace sbox
