// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox/core/round.h"

using namespace sbox;

TEST_CASE("whole numbers below and above are those of the standard library", "[core]") {
  for (int whole = -5; whole <= 5; ++whole) {
    for (const double off : {0.0, 1e-12, 0.25, 0.5, 0.999}) {
      for (const double value : {whole + off, whole - off}) {
        INFO(value);
        CHECK(floorToInt(value) == static_cast<int>(std::floor(value)));
        CHECK(ceilToInt(value) == static_cast<int>(std::ceil(value)));
      }
    }
  }
  CHECK(floorToInt(-2147483647.5) == -2147483647 - 1);
  CHECK(ceilToInt(2147483646.5) == 2147483647);
}
