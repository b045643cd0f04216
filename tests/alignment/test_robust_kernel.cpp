// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/alignment/robust_kernel.h"

using namespace sbox;

TEST_CASE("a residual counts fully near zero, half at the scale and hardly beyond", "[alignment]") {
  CHECK(gemanMcClureShare(0, 0.3) == 1);
  CHECK(gemanMcClureShare(0.3 * 0.3, 0.3) == Approx(0.5));
  CHECK(gemanMcClureShare(900 * 0.3 * 0.3, 0.3) == Approx(1.0 / 901));
}

TEST_CASE("the weight is the slope of the loss over the squared residual", "[alignment]") {
  const double scale = 0.4, step = 1e-6;
  const auto loss = [&](double squared) { return squared * gemanMcClureShare(squared, scale); };
  for (const double squared : {0.01, 0.16, 1.0, 9.0}) {
    const double share = gemanMcClureShare(squared, scale);
    CHECK((loss(squared + step) - loss(squared - step)) / (2 * step) == Approx(share * share));
  }
}

TEST_CASE("the scale goes geometrically from the first round to the last", "[alignment]") {
  CHECK(scaleOfRound(0, 5, 1.6, 0.1) == 1.6);
  CHECK(scaleOfRound(1, 5, 1.6, 0.1) == Approx(0.8));
  CHECK(scaleOfRound(2, 5, 1.6, 0.1) == Approx(0.4));
  CHECK(scaleOfRound(4, 5, 1.6, 0.1) == Approx(0.1));
  CHECK(scaleOfRound(0, 1, 1.6, 0.1) == Approx(0.1));
}
