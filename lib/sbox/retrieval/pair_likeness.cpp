// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/retrieval/pair_likeness.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "sbox/alignment/plausibility.h"
#include "sbox/core/sort_descending.h"

namespace sbox {
namespace {

bool hasCorner(const MapFeatures& map) {
  return std::any_of(map.frames.begin(), map.frames.end(),
                     [](const FrameFeatures& frame) { return !frame.corners.empty(); });
}

double likenessInOrder(const MapFeatures& a, const MapFeatures& b, const LikenessOptions& options,
                       VoteOptions votes, const EvidenceWeights& weights) {
  votes.max_hypotheses = options.max_hypotheses;
  votes.min_per_heading = options.min_per_heading;
  const auto scored = [&](const RigidTransform& b_in_a, int points) {
    return plausibility(measureOverlap(a, b, b_in_a, static_cast<size_t>(points), weights));
  };
  std::vector<std::pair<double, RigidTransform>> ranked;
  for (const Hypothesis& hypothesis : voteForTransforms(a, b, votes)) {
    ranked.emplace_back(scored(hypothesis.b_in_a, options.first_points), hypothesis.b_in_a);
  }
  sortDescending(ranked, [](const auto& candidate) { return candidate.first; });
  ranked.resize(std::min(ranked.size(), static_cast<size_t>(std::max(options.kept, 0))));
  double best = kImplausible;
  for (const auto& [first_score, b_in_a] : ranked) {
    best = std::max(best, scored(b_in_a, options.points));
  }
  return best;
}

}  // namespace

double pairLikeness(const MapFeatures& a, const MapFeatures& b, const LikenessOptions& options,
                    const VoteOptions& votes, const EvidenceOptions& evidence) {
  if (!hasCorner(a) || !hasCorner(b)) {
    return std::numeric_limits<double>::infinity();
  }
  const EvidenceWeights weights(evidence);
  return comesFirst(b, a) ? likenessInOrder(b, a, options, votes, weights)
                          : likenessInOrder(a, b, options, votes, weights);
}

}  // namespace sbox
