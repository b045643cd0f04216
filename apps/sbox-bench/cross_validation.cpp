// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/cross_validation.h"

#include <algorithm>

#include "sbox-bench/calibration.h"

namespace sbox::bench {
namespace {

constexpr size_t kFolds = 3;

/// Pairs of one folder come in an order that puts like ones together; runs of them stay in one
/// fold.
size_t foldOf(size_t sample) {
  constexpr size_t run = 3;
  return sample / run % kFolds;
}

}  // namespace

Table crossValidation(const std::vector<VerdictSample>& samples,
                      const std::vector<std::string>& folder_names, double accept_from) {
  std::vector<VerdictModel> models;
  for (size_t fold = 0; fold < kFolds; ++fold) {
    std::vector<VerdictSample> others;
    for (size_t i = 0; i < samples.size(); ++i) {
      if (foldOf(i) != fold) {
        others.push_back(samples[i]);
      }
    }
    models.push_back(fitModel(others));
  }
  struct Count {
    int pairs = 0, right = 0, wrong = 0;
  };
  std::vector<Count> of_folder(folder_names.size());
  ConfidenceBins confidences({0, 0.5, 0.7, 0.9, 0.97, 1});
  for (size_t i = 0; i < samples.size(); ++i) {
    const std::vector<double> p = probabilities(samples[i], models[foldOf(i)]);
    Count& count = of_folder[samples[i].folder];
    ++count.pairs;
    if (p.empty()) {
      continue;
    }
    const auto best = static_cast<size_t>(std::max_element(p.begin(), p.end()) - p.begin());
    const bool right = samples[i].right[best];
    if (p[best] >= accept_from) {
      ++(right ? count.right : count.wrong);
    }
    confidences.add(p[best], right);
  }
  Table table;
  table.header = {"left out of the fit", "pairs",      "right", "wrong",
                  "mean confidence",     "right share"};
  for (size_t f = 0; f < of_folder.size(); ++f) {
    table.rows.push_back({folder_names[f], std::to_string(of_folder[f].pairs),
                          std::to_string(of_folder[f].right), std::to_string(of_folder[f].wrong),
                          "", ""});
  }
  for (const ReliabilityBin& bin : confidences.bins()) {
    if (bin.answers > 0) {
      table.rows.push_back({rangeText(bin), std::to_string(bin.answers), std::to_string(bin.right),
                            "", formatNumber(bin.mean_confidence, 3),
                            formatNumber(bin.right / static_cast<double>(bin.answers), 3)});
    }
  }
  return table;
}

}  // namespace sbox::bench
