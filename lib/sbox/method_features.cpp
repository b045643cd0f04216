// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/method_features.h"

namespace sbox {

MethodFeatures extractMethodFeatures(const Map& map, const MergeOptions& options) {
  if (options.method == Method::Boxes) {
    return extractFeatures(map, options.pair.features);
  }
  return extractPaperFeatures(map, options.paper);
}

const StateOptions& statesOf(const MergeOptions& options) {
  return options.method == Method::Boxes ? options.pair.features.states : options.paper.states;
}

PairResult matchMethodFeatures(const MethodFeatures& a, const MethodFeatures& b,
                               const MergeOptions& options,
                               const std::optional<GuessedPoses>& guess, int threads) {
  if (const auto* of_a = std::get_if<MapFeatures>(&a)) {
    return matchPair(*of_a, std::get<MapFeatures>(b), options.pair, guess, threads);
  }
  return matchPaper(std::get<PaperFeatures>(a), std::get<PaperFeatures>(b), options.paper);
}

const FeatureSet& featureSetOf(const MethodFeatures& features) {
  return std::visit(
      [](const auto& of_method) -> const FeatureSet& { return of_method.feature_set; }, features);
}

}  // namespace sbox
