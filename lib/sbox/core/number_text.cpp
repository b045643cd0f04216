// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace sbox {
namespace {

/// As std::to_chars writes it.
template <typename... Number>
std::string textOf(Number... value) {
  // The smallest double takes 326 characters without an exponent.
  std::array<char, 400> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value...);
  return error == std::errc() ? std::string(text.data(), end) : std::string();
}

}  // namespace

std::string numberText(double value) { return textOf(value); }
std::string numberText(float value) { return textOf(value); }
std::string plainNumberText(double value) { return textOf(value, std::chars_format::fixed); }

std::string fixedDigits(double value, int digits) {
  const double unit = std::pow(10.0, digits);
  const double rounded = std::round(value * unit) / unit;
  return textOf(rounded == 0 ? 0.0 : rounded, std::chars_format::fixed, digits);
}

std::string scientificDigits(double value, int digits) {
  return textOf(value == 0 ? 0.0 : value, std::chars_format::scientific, digits);
}

std::optional<double> parseNumber(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
    text.remove_prefix(1);
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

}  // namespace sbox
