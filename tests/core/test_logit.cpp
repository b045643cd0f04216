// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/core/logit.h"

using namespace sbox;

TEST_CASE("probabilities are shares of the odds of all answers and of none", "[core]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-9, 9);
  for (size_t count = 0; count < 6; ++count) {
    std::vector<double> log_odds(count);
    for (double& value : log_odds) {
      value = uniform(random);
    }
    const double none = uniform(random);
    double sum = std::exp(none);
    for (const double value : log_odds) {
      sum += std::exp(value);
    }
    const std::vector<double> probabilities = probabilitiesByLogit(log_odds, none);
    REQUIRE(probabilities.size() == count);
    for (size_t i = 0; i < count; ++i) {
      CHECK(probabilities[i] == Approx(std::exp(log_odds[i]) / sum));
    }
  }
}

TEST_CASE("log odds that no exponent holds are compared", "[core]") {
  CHECK(probabilitiesByLogit({1e5, 1e5}, 0)[1] == Approx(0.5));
  CHECK(probabilitiesByLogit({-1e5}, -1e5)[0] == Approx(0.5));
  CHECK(probabilitiesByLogit({0}, 1e5)[0] == 0);
}
