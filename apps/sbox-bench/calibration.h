// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a method knows how sure it may be: confidence against the share that is right, and
// covariance against the error.
#pragma once

#include <string>
#include <vector>

#include "sbox-bench/score_table.h"

namespace sbox::bench {

/// Answers whose confidence lies in [from, to), the last bin with its upper end.
struct ReliabilityBin {
  double from = 0;
  double to = 1;
  int answers = 0;
  int right = 0;               ///< Of them, accepted or not.
  double mean_confidence = 0;  ///< NaN for none.
  int accepted = 0;            ///< Of the answers.
  int accepted_right = 0;
};

/// Counts answers by their confidence.
class ConfidenceBins {
 public:
  /// Bins between these edges, which ascend.
  explicit ConfidenceBins(const std::vector<double>& edges);
  /// Counts an answer, right or not, and gives its bin.
  ReliabilityBin& add(double confidence, bool right);
  /// All bins, ascending.
  [[nodiscard]] std::vector<ReliabilityBin> bins() const;

 private:
  std::vector<ReliabilityBin> bins_;  ///< With the sum of confidences in place of their mean.
};

/// "0.70 to 0.80".
[[nodiscard]] std::string rangeText(const ReliabilityBin& bin);

/// How confidences compare with what was right.
struct Reliability {
  std::vector<ReliabilityBin> bins;
  int answers = 0;   ///< With a pose; a pose for a pair with nothing in common counts as not right.
  double brier = 0;  ///< Mean squared difference of confidence and right (1) or not (0); NaN: none.
};

[[nodiscard]] Reliability reliability(const std::vector<const Answer*>& answers);

/// One row a bin that has answers, over all answers of the run, and the Brier score.
[[nodiscard]] Table reliabilityTable(const MethodRun& run);

/// One row a group that has covariances: mean normalised errors of the right answers beside the
/// band that holds them in 95 of 100 cases if covariances are honest and errors independent.
[[nodiscard]] Table normalisedErrorTable(const MethodRun& run);

}  // namespace sbox::bench
