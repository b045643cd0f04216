// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/calibration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sbox-bench/statistics.h"

namespace sbox::bench {
namespace {

constexpr double kNoMean = std::numeric_limits<double>::quiet_NaN();
/// Chi-squared of 3 degrees of freedom, 95th percentile.
constexpr double kOneAnswer95 = 7.815;

}  // namespace

ConfidenceBins::ConfidenceBins(const std::vector<double>& edges) {
  for (size_t i = 0; i + 1 < edges.size(); ++i) {
    bins_.push_back({edges[i], edges[i + 1], 0, 0, 0, 0, 0});
  }
}

ReliabilityBin& ConfidenceBins::add(double confidence, bool right) {
  const auto above = std::find_if(bins_.begin(), bins_.end() - 1,
                                  [&](const ReliabilityBin& bin) { return confidence < bin.to; });
  ++above->answers;
  above->right += right ? 1 : 0;
  above->mean_confidence += confidence;
  return *above;
}

std::vector<ReliabilityBin> ConfidenceBins::bins() const {
  std::vector<ReliabilityBin> means = bins_;
  for (ReliabilityBin& bin : means) {
    bin.mean_confidence = bin.answers > 0 ? bin.mean_confidence / bin.answers : kNoMean;
  }
  return means;
}

std::string rangeText(const ReliabilityBin& bin) {
  return formatNumber(bin.from, 2) + " to " + formatNumber(bin.to, 2);
}

Reliability reliability(const std::vector<const Answer*>& answers) {
  Reliability result;
  ConfidenceBins bins({0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99, 1});
  for (const Answer* answer : answers) {
    if (!answer->result.has_pose) {
      continue;
    }
    const double confidence = answer->result.confidence;
    const int right = answer->poseRight() ? 1 : 0;
    ReliabilityBin& bin = bins.add(confidence, answer->poseRight());
    if (answer->result.verdict == Verdict::Accepted) {
      ++bin.accepted;
      bin.accepted_right += right;
    }
    ++result.answers;
    result.brier += (confidence - right) * (confidence - right);
  }
  result.bins = bins.bins();
  result.brier = result.answers > 0 ? result.brier / result.answers : kNoMean;
  return result;
}

Table reliabilityTable(const MethodRun& run) {
  std::vector<const Answer*> answers;
  for (const FolderAnswers& folder : run.folders) {
    for (const Answer& answer : folder.answers) {
      answers.push_back(&answer);
    }
  }
  const Reliability all = reliability(answers);
  Table table{{run.method + ", confidence", "answers", "mean confidence", "right share", "accepted",
               "of them right"},
              {}};
  for (const ReliabilityBin& bin : all.bins) {
    if (bin.answers == 0) {
      continue;
    }
    const double share = static_cast<double>(bin.right) / bin.answers;
    table.rows.push_back({rangeText(bin), std::to_string(bin.answers),
                          formatNumber(bin.mean_confidence, 3), formatNumber(share, 3),
                          std::to_string(bin.accepted), std::to_string(bin.accepted_right)});
  }
  table.rows.push_back(
      {"Brier score " + formatNumber(all.brier, 4), std::to_string(all.answers), "", "", "", ""});
  return table;
}

Table normalisedErrorTable(const MethodRun& run) {
  Table table{
      {run.method + ", e' P^-1 e", "answers", "mean", "median", "mean, truth's error counted",
       "median", "95 % band of means", "below 7.8 (honest: 0.95)"},
      {}};
  for (const Group& group : groupAnswers(run)) {
    std::vector<double> of_answers, of_differences;
    for (const Answer* answer : group.answers) {
      if (answer->outcome == Outcome::Right && answer->normalised_error) {
        of_answers.push_back(answer->normalised_error->of_answer);
        of_differences.push_back(answer->normalised_error->of_difference);
      }
    }
    if (of_answers.empty()) {
      continue;
    }
    const auto n = static_cast<double>(of_answers.size());
    const auto mean = [&](const std::vector<double>& values) {
      return std::accumulate(values.begin(), values.end(), 0.0) / n;
    };
    const auto inside = std::count_if(of_differences.begin(), of_differences.end(),
                                      [](double value) { return value <= kOneAnswer95; });
    table.rows.push_back({group.name, std::to_string(of_answers.size()),
                          formatNumber(mean(of_answers), 2), formatNumber(median(of_answers), 2),
                          formatNumber(mean(of_differences), 2),
                          formatNumber(median(of_differences), 2),
                          formatNumber(chiSquaredBound(3 * n, false) / n, 2) + " to " +
                              formatNumber(chiSquaredBound(3 * n, true) / n, 2),
                          formatNumber(static_cast<double>(inside) / n, 2)});
  }
  return table;
}

}  // namespace sbox::bench
