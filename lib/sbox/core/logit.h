// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace sbox {

/// Probability of each of several answers of which at most one is right, by a logit model:
/// exp(log_odds[i]) over the sum of all and of exp(none). They add up to less than 1; the rest is
/// the probability of none. Log odds may be larger than a double's exponent can hold.
[[nodiscard]] std::vector<double> probabilitiesByLogit(const std::vector<double>& log_odds,
                                                       double none);

}  // namespace sbox
