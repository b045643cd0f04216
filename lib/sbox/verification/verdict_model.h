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
/// straight walls in common that agree; log of the clutter that agrees (metres); log of the
/// agreeing wall (metres) across the others; root of the straight wall deep in the other's free
/// space (metres); straight wall in conflict where that is shallow, and clutter in conflict, by the
/// shallow free area in common; how bent the maps are against each other over how bent each is
/// (Fit::bend_ratio), as far as walls are bare; share of the rooms in common whose walls do not
/// fit: conflict that lies together, as of a wing that drift has carried off, counts less than as
/// much strewn all over. All with the drift taken out.
[[nodiscard]] std::array<double, kVerdictTerms> verdictTerms(const Fit& fit);

/// Agreeing wall that fixes the shift in the direction that is fixed least, metres.
[[nodiscard]] double crossWall(const Evidence& evidence);

/// Weights found by maximum likelihood: `sbox-bench FOLDERS --fit-verdict` prints them.
struct VerdictModel {
  /// Of the terms, in their order.
  std::array<double, kVerdictTerms> weights = {11.217,  2.8762,  1.9432, -2.5644,
                                               -39.784, -16.464, -6.425, 4.1432};
  double none = 13.048;  ///< Log odds of "none of the fits is right".
};

/// Log odds that the fit of these terms is right, up to a constant.
[[nodiscard]] double logOdds(const std::array<double, kVerdictTerms>& terms,
                             const VerdictModel& model = {});

/// Sets log_odds and probability of each fit, and sorts them, the most probable first.
void judge(std::vector<Fit>& fits, const VerdictModel& model = {});

}  // namespace sbox
