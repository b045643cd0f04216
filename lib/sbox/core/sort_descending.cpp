// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/sort_descending.h"

#include <algorithm>
#include <numeric>

namespace sbox {

std::vector<size_t> descendingOrder(const std::vector<double>& keys) {
  std::vector<size_t> order(keys.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t left, size_t right) { return keys[left] > keys[right]; });
  return order;
}

}  // namespace sbox
