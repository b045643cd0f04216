// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From evidence to probability and verdict. All fits of a pair compete with each other and with
// "none of them" in one conditional logit model, so that a poor fit and a good fit that has a rival
// both end with a low probability.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/pair_result.h"
#include "sbox/verification/fit.h"

namespace sbox {

struct VerdictOptions {
  double accept_from = 0.7;  ///< Probability from which the best fit is accepted.
};

/// Sets log_odds and probability of each fit, and sorts by it, the most probable first.
void judge(std::vector<Fit>& fits);

/// The verdict on the best of judged fits, and the reason in words.
struct Verdicted {
  Verdict verdict = Verdict::Rejected;
  std::string reason;
};
[[nodiscard]] Verdicted decide(const std::vector<Fit>& fits, const VerdictOptions& options = {});

}  // namespace sbox
