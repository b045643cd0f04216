// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/verification/rank_hypotheses.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/pose.h"
#include "sbox/verification/plausibility.h"
#include "sbox/verification/same_answer.h"

namespace sbox {
namespace {

struct Ranked {
  RigidTransform b_in_a;
  double score = 0;
};

void keepBest(std::vector<Ranked>& ranked, int count) {
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& left, const Ranked& right) {
    return left.score > right.score;
  });
  ranked.resize(std::min(ranked.size(), static_cast<size_t>(std::max(count, 0))));
}

void score(const MapFeatures& a, const MapFeatures& b, std::vector<Ranked>& ranked, int points,
           const EvidenceWeights& weights) {
  for (Ranked& candidate : ranked) {
    candidate.score =
        plausibility(gatherEvidence(a, b, candidate.b_in_a, static_cast<size_t>(points), weights));
  }
}

/// Drops what is the same answer as a better one; `ranked` is in order.
void keepDistinct(std::vector<Ranked>& ranked, int count, const Eigen::Vector2d& centre_b,
                  const RankingOptions& options) {
  std::vector<Ranked> distinct;
  for (const Ranked& candidate : ranked) {
    if (static_cast<int>(distinct.size()) >= count) {
      break;
    }
    const bool is_new = std::none_of(distinct.begin(), distinct.end(), [&](const Ranked& other) {
      return isSameAnswer(candidate.b_in_a, other.b_in_a, centre_b, options.same_distance,
                          options.same_turn * M_PI / 180);
    });
    if (is_new) {
      distinct.push_back(candidate);
    }
  }
  ranked = std::move(distinct);
}

/// Slopes that the drift gives to walls, over those that walls have within a map: what bends maps
/// against each other bends each in itself.
double bendRatio(const MapFeatures& a, const MapFeatures& b, const DriftField& drift) {
  constexpr double least_slope = 0.005;  // Cells show none below.
  const double slope = drift.roughness() / drift.spacing;
  return slope / std::max({a.slope_spread, b.slope_spread, least_slope});
}

}  // namespace

bool isSameAnswer(const RigidTransform& left, const RigidTransform& right,
                  const Eigen::Vector2d& centre_b, double distance, double turn) {
  return (left * centre_b - right * centre_b).norm() < distance &&
         std::abs(wrapAngle(left.heading - right.heading)) < turn;
}

std::vector<Fit> rankHypotheses(const MapFeatures& a, const MapFeatures& b,
                                const std::vector<Hypothesis>& hypotheses,
                                const RankingOptions& options) {
  const Eigen::Vector2d centre_b(b.width / 2, b.height / 2);
  std::vector<Ranked> ranked;
  ranked.reserve(hypotheses.size());
  for (const Hypothesis& hypothesis : hypotheses) {
    ranked.push_back({hypothesis.b_in_a, 0});
  }
  const EvidenceWeights weights(options.evidence), bent_weights(options.bent_evidence);
  score(a, b, ranked, options.first_points, weights);
  keepBest(ranked, options.first_kept);
  score(a, b, ranked, options.coarse_points, weights);
  keepBest(ranked, options.coarse_kept);
  score(a, b, ranked, options.fine_points, weights);
  keepBest(ranked, options.coarse_kept);
  keepDistinct(ranked, options.aligned, centre_b, options);
  for (const AlignmentOptions& alignment : {options.first_alignment, options.alignment}) {
    for (Ranked& candidate : ranked) {
      candidate.b_in_a = alignWalls(a, b, candidate.b_in_a, alignment);
    }
    score(a, b, ranked, 2 * options.fine_points, weights);
    keepBest(ranked, options.aligned);
    keepDistinct(ranked, options.kept, centre_b, options);
  }

  std::vector<Fit> fits;
  for (const Ranked& candidate : ranked) {
    if (candidate.score <= kImplausible ||
        candidate.score < ranked.front().score - options.kept_within) {
      break;
    }
    Fit fit;
    fit.b_in_a = candidate.b_in_a;
    fit.evidence =
        gatherEvidence(a, b, fit.b_in_a, static_cast<size_t>(options.bent_points), weights);
    fit.drift = estimateDrift(a, b, fit.b_in_a, options.drift);
    fit.bent_evidence = gatherEvidence(a, b, fit.b_in_a, fit.drift,
                                       static_cast<size_t>(options.bent_points), bent_weights);
    const bool is_known = std::any_of(fits.begin(), fits.end(), [&](const Fit& other) {
      return distanceWhenBent(a, b, fit, other) < options.same_bent;
    });
    if (is_known) {
      continue;
    }
    fit.bend_ratio = bendRatio(a, b, fit.drift);
    fit.boxes = static_cast<int>(matchBoxes(a, b, fit.b_in_a, fit.drift, options.boxes).size());
    fits.push_back(std::move(fit));
  }
  return fits;
}

}  // namespace sbox
