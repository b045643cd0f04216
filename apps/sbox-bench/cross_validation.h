// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far the verdict's probabilities can be trusted, shown on pairs that were left out of the fit.
#pragma once

#include <string>
#include <vector>

#include "sbox-bench/fit_verdict.h"
#include "sbox-bench/table.h"

namespace sbox::bench {

/// Reliability in three-fold cross-validation: each third of the pairs is judged by a model fitted
/// to the others. `accept_from`: probability from which an answer counts as given.
[[nodiscard]] Table crossValidation(const std::vector<VerdictSample>& samples,
                                    const std::vector<std::string>& folder_names,
                                    double accept_from);

}  // namespace sbox::bench
