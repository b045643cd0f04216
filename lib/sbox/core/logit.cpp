// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/logit.h"

#include <algorithm>
#include <cmath>

namespace sbox {

std::vector<double> probabilitiesByLogit(const std::vector<double>& log_odds, double none) {
  double highest = none;
  for (const double value : log_odds) {
    highest = std::max(highest, value);
  }
  double sum = std::exp(none - highest);
  std::vector<double> probabilities;
  for (const double value : log_odds) {
    probabilities.push_back(std::exp(value - highest));
    sum += probabilities.back();
  }
  for (double& probability : probabilities) {
    probability /= sum;
  }
  return probabilities;
}

}  // namespace sbox
