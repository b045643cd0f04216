// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fits the weights of the verdict's model (sbox/verification/verdict_model.h) to pairs with known
// truth.
#pragma once

#include <array>
#include <vector>

#include "sbox-bench/run_method.h"
#include "sbox/verification/verdict_model.h"

namespace sbox::bench {

/// One pair of maps: its answers, and which of them are right as they would be reported (none for
/// maps without common place).
struct VerdictSample {
  size_t folder = 0;
  double folder_weight = 1;  ///< Of the folder, which all its pairs share.
  std::vector<std::array<double, kVerdictTerms>> terms;
  std::vector<bool> right;
};

/// The answers of every pair of a folder, with the default options. Which fit stands for an answer
/// depends on the default model's weights: fit again until these stay. `folder`: its number.
[[nodiscard]] std::vector<VerdictSample> collectSamples(const LoadedFolder& loaded, size_t folder,
                                                        double folder_weight, int threads);

/// The most likely model. Folders count by their weights, however many pairs they have; `ridge`
/// keeps weights (of terms scaled to unit variance) small.
[[nodiscard]] VerdictModel fitModel(const std::vector<VerdictSample>& samples, double ridge = 2e-4);

/// Probability of each answer of a sample.
[[nodiscard]] std::vector<double> probabilities(const VerdictSample& sample,
                                                const VerdictModel& model);

}  // namespace sbox::bench
