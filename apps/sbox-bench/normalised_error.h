// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a covariance tells how far a pose is from the truth.
#pragma once

#include <optional>

#include "sbox-bench/annotated_truth.h"
#include "sbox/core/pair_result.h"

namespace sbox::bench {

/// Normalised estimation error squared, e^T P^-1 e, of the pose of b in a. The error e = (x, y,
/// phi) and its covariance P are taken about the middle of the annotated points: about a far-off
/// origin the first-order P says little. Averages 3 where covariances are honest.
struct NormalisedError {
  double of_answer = 0;      ///< P of the answer alone, as if the annotated pose were exact.
  double of_difference = 0;  ///< P of the answer and of the annotated fit: what honest errors give.
};

/// None if the covariance is unknown (PairResult's default) or not positive definite.
[[nodiscard]] std::optional<NormalisedError> normalisedError(const PairResult& result,
                                                             const AnnotatedTruth& truth);

}  // namespace sbox::bench
