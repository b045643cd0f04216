// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From evidence to probability. All fits of a pair compete with each other and with "none of them"
// in one conditional logit model, so that a poor fit and a good fit that has a rival both end with
// a low probability.
#pragma once

#include <array>
#include <vector>

#include "sbox/verification/fit.h"

namespace sbox {

/// Number of terms of the model.
constexpr size_t kVerdictTerms = 8;

/// What the log odds of a fit are made of, in the order of VerdictModel::weights: share of the
/// walls in common that agree; log of the agreeing wall (metres) across the others; roots of the
/// wall in conflict (metres), rigid and bent; conflict per shared area; root and log share of the
/// shared free area (square metres); log of the boxes that agree.
[[nodiscard]] std::array<double, kVerdictTerms> verdictTerms(const Fit& fit);

/// Agreeing wall that fixes the shift in the direction that is fixed least, metres.
[[nodiscard]] double crossWall(const Evidence& evidence);

/// Weights found by maximum likelihood: `sbox-bench FOLDERS --fit-verdict` prints them.
struct VerdictModel {
  /// Of the terms, in their order.
  std::array<double, kVerdictTerms> weights = {20.634,  0.936,  -0.2173, -0.3587,
                                               -10.255, 0.3483, 0.7715,  0.4869};
  double none = 13.976;  ///< Log odds of "none of the fits is right".
};

/// Sets log_odds and probability of each fit, and sorts them, the most probable first.
void judge(std::vector<Fit>& fits, const VerdictModel& model = {});

}  // namespace sbox
