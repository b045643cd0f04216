// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>
#include <vector>

#include "catch.h"
#include "sbox/core/sort_descending.h"

using sbox::descendingOrder;
using sbox::sortDescending;

TEST_CASE("the largest key comes first, equal ones stay in order", "[core]") {
  CHECK(descendingOrder({}).empty());
  CHECK(descendingOrder({1, 3, 2, 3}) == std::vector<size_t>{1, 3, 2, 0});

  std::vector<std::pair<std::string, int>> named{{"a", 1}, {"b", 3}, {"c", 2}, {"d", 3}, {"e", -7}};
  sortDescending(named, [](const auto& each) { return each.second; });
  const std::vector<std::pair<std::string, int>> sorted{
      {"b", 3}, {"d", 3}, {"c", 2}, {"a", 1}, {"e", -7}};
  CHECK(named == sorted);
}
