// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/words.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/number_text.h"

namespace sbox {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

double roundLength(double metres) {
  const double power = std::pow(10.0, std::floor(std::log10(metres)));
  const double lead = metres / power;
  return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

std::string lengthText(double round_metres) {
  const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(round_metres) + 1e-9)));
  return fixedDigits(round_metres, digits) + " m";
}

}  // namespace sbox
