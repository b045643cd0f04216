// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/fixed_digits.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace sbox {

std::string fixedDigits(double value, int digits) {
  const double unit = std::pow(10.0, digits);
  const double rounded = std::round(value * unit) / unit;
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << (rounded == 0 ? 0.0 : rounded);
  return out.str();
}

}  // namespace sbox
