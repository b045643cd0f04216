// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox-bench/table.h"

using namespace sbox::bench;

TEST_CASE("a table aligns its columns", "[bench][table]") {
  const Table table{{"group", "n"}, {{"a", "100"}, {"offices", "7"}}};
  CHECK(toText(table, false) ==
        "group      n\n"
        "a        100\n"
        "offices    7\n");
  CHECK(toText(table, true) ==
        "| group   |   n |\n"
        "|---------|----:|\n"
        "| a       | 100 |\n"
        "| offices |   7 |\n");
}

TEST_CASE("a missing number is a dash", "[bench][table]") {
  CHECK(formatNumber(1.25, 1) == "1.2");
  CHECK(formatNumber(std::nan(""), 2) == "-");
}
