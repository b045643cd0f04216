// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox-bench/statistics.h"

using namespace sbox::bench;

TEST_CASE("the median of an even number is the mean of the middle two", "[bench][statistics]") {
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 2, 10}) == 3);
  CHECK(std::isnan(median({})));
  CHECK(minimum({3, 1, 2}) == 1);
  CHECK(maximum({3, 1, 2}) == 3);
  CHECK(std::isnan(maximum({})));
}

TEST_CASE("chi-squared bounds agree with the tables", "[bench][statistics]") {
  // NIST/SEMATECH handbook, 1.3.6.7.4.
  CHECK(chiSquaredBound(3, true) == Approx(9.348).epsilon(0.01));
  CHECK(chiSquaredBound(10, false) == Approx(3.247).epsilon(0.01));
  CHECK(chiSquaredBound(10, true) == Approx(20.483).epsilon(0.001));
  CHECK(chiSquaredBound(100, false) == Approx(74.222).epsilon(0.001));
  CHECK(chiSquaredBound(100, true) == Approx(129.561).epsilon(0.001));
}
