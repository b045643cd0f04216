// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers as text, the same in every locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sbox {

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string numberText(double value);
/// As above for a float: 0.05F gives "0.05".
[[nodiscard]] std::string numberText(float value);

/// The shortest such text without an exponent, which PyYAML takes for a word ("1e-07").
[[nodiscard]] std::string plainNumberText(double value);

/// `value` with `digits` decimals, for people; never "-0".
[[nodiscard]] std::string fixedDigits(double value, int digits);

/// `value` with an exponent and `digits` decimals before it, for people.
[[nodiscard]] std::string scientificDigits(double value, int digits);

/// The number that the whole text spells, or nothing. Accepts a leading "+"; NaN and infinity are
/// no numbers here.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

}  // namespace sbox
