// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the probabilities of a pair's fits (verdict_model.h) to a verdict with its reason in words.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/pair_result.h"
#include "sbox/verification/fit.h"

namespace sbox {

/// When to accept.
struct VerdictOptions {
  double accept_from = 0.7;  ///< Probability from which the best fit is accepted.
};

/// The verdict on the best of judged fits, and the reason in words.
struct Verdicted {
  Verdict verdict = Verdict::Rejected;  ///< On the best fit.
  std::string reason;                   ///< One sentence.
};
[[nodiscard]] Verdicted decide(const std::vector<Fit>& fits, const VerdictOptions& options = {});

}  // namespace sbox
