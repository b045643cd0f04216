// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbox::bench {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kNormal975 = 1.959963984540054;

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) {
    return kNone;
  }
  std::sort(values.begin(), values.end());
  const size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double maximum(const std::vector<double>& values) {
  return values.empty() ? kNone : *std::max_element(values.begin(), values.end());
}

double minimum(const std::vector<double>& values) {
  return values.empty() ? kNone : *std::min_element(values.begin(), values.end());
}

double chiSquaredBound(double degrees, bool upper) {
  const double spread = 2 / (9 * degrees);
  const double root = 1 - spread + (upper ? kNormal975 : -kNormal975) * std::sqrt(spread);
  return degrees * root * root * root;
}

}  // namespace sbox::bench
