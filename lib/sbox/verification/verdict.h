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
  double accept_from = 0.7;  ///< Probability from which the best fit is accepted, unless ...
  /// ... a rival at least this probable has nothing against it: repeated rooms and corridors.
  double rival_from = 0.05;
  double rival_agree = 0.85;     ///< Share of the common wall that agrees in such a rival.
  double rival_conflict = 0.02;  ///< Share of it that conflicts, at most.
};

/// What was decided of a pair.
struct Verdicted {
  Verdict verdict = Verdict::Rejected;  ///< On the best fit.
  std::string reason;                   ///< One sentence.
};

/// The verdict on the best of judged fits (see judge()), and the reason in words.
[[nodiscard]] Verdicted decide(const std::vector<Fit>& fits, const VerdictOptions& options = {});

}  // namespace sbox
