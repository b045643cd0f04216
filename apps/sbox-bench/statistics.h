// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace sbox::bench {

/// The middle value, the mean of the middle two for an even number; NaN for none.
[[nodiscard]] double median(std::vector<double> values);

/// The largest value; NaN for none.
[[nodiscard]] double maximum(const std::vector<double>& values);

/// The smallest value; NaN for none.
[[nodiscard]] double minimum(const std::vector<double>& values);

/// Value that a chi-squared variable of `degrees` > 0 degrees of freedom stays below with
/// probability 0.025 (`upper` false) or 0.975, by Wilson and Hilferty's cube-root normal.
[[nodiscard]] double chiSquaredBound(double degrees, bool upper);

}  // namespace sbox::bench
