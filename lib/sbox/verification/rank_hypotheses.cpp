// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/verification/rank_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sbox/alignment/plausibility.h"
#include "sbox/core/parallel.h"
#include "sbox/core/pose.h"
#include "sbox/core/sort_descending.h"
#include "sbox/verification/same_answer.h"
#include "sbox/verification/verdict_model.h"

namespace sbox {
namespace {

struct Ranked {
  RigidTransform b_in_a;
  double score = 0;
};

void keepBest(std::vector<Ranked>& ranked, int count) {
  sortDescending(ranked, [](const Ranked& candidate) { return candidate.score; });
  ranked.resize(std::min(ranked.size(), static_cast<size_t>(std::max(count, 0))));
}

double scoreOf(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a, int points,
               const EvidenceWeights& weights) {
  return plausibility(measureOverlap(a, b, b_in_a, static_cast<size_t>(points), weights));
}

void score(const MapFeatures& a, const MapFeatures& b, std::vector<Ranked>& ranked, int points,
           const EvidenceWeights& weights, int threads) {
  parallelFor(static_cast<int>(ranked.size()), threads, [&](int i) {
    Ranked& candidate = ranked[static_cast<size_t>(i)];
    candidate.score = scoreOf(a, b, candidate.b_in_a, points, weights);
  });
}

/// Whether transforms that put a point this far apart and differ by this angle are near each other.
bool areNear(const Eigen::Vector2d& apart, double turned, double distance, double turn) {
  return apart.norm() < distance && std::abs(wrapAngle(turned)) < turn;
}

/// Drops what is the same answer as a better one; `ranked` is in order.
void keepDistinct(std::vector<Ranked>& ranked, int count, const Eigen::Vector2d& centre_b,
                  const RankingOptions& options) {
  const double turn = options.same_turn * M_PI / 180;
  std::vector<Ranked> distinct;
  std::vector<Eigen::Vector2d> centres;  // Of map b, by each of these.
  for (const Ranked& candidate : ranked) {
    if (static_cast<int>(distinct.size()) >= count) {
      break;
    }
    const Eigen::Vector2d centre = candidate.b_in_a * centre_b;
    bool is_new = true;
    for (size_t i = 0; i < distinct.size() && is_new; ++i) {
      is_new = !areNear(centre - centres[i], candidate.b_in_a.heading - distinct[i].b_in_a.heading,
                        options.same_distance, turn);
    }
    if (is_new) {
      distinct.push_back(candidate);
      centres.push_back(centre);
    }
  }
  ranked = std::move(distinct);
}

/// Drops what is far less plausible than the best; `ranked` is in order.
void dropHopeless(std::vector<Ranked>& ranked, double within) {
  const auto is_hopeless = [&](const Ranked& candidate) {
    return candidate.score <= kImplausible || candidate.score < ranked.front().score - within;
  };
  ranked.erase(std::find_if(ranked.begin(), ranked.end(), is_hopeless), ranked.end());
}

/// Slopes that the drift gives to walls, over those that walls have within a map: what bends maps
/// against each other bends each in itself.
double bendRatio(const MapFeatures& a, const MapFeatures& b, const DriftField& drift) {
  constexpr double least_slope = 0.005;  // Cells show none below.
  const double slope = drift.roughness() / drift.spacing;
  return slope / std::max({a.slope_spread, b.slope_spread, least_slope});
}

/// How candidates are laid on the walls.
enum class Alignment {
  Free,    ///< Whatever becomes of the score: right where maps are bent.
  Careful  ///< Only where the score rises: right among clutter, where the kernel, which is wide,
           ///< leads away from a good start.
};

void align(const MapFeatures& a, const MapFeatures& b, std::vector<Ranked>& ranked,
           const AlignmentOptions& alignment, Alignment how, const RankingOptions& options,
           const EvidenceWeights& weights, int threads) {
  const int points = 2 * options.fine_points;
  parallelFor(static_cast<int>(ranked.size()), threads, [&](int i) {
    Ranked& candidate = ranked[static_cast<size_t>(i)];
    const RigidTransform aligned = alignWalls(a, b, candidate.b_in_a, alignment);
    const double aligned_score = scoreOf(a, b, aligned, points, weights);
    if (how == Alignment::Careful) {
      candidate.score = scoreOf(a, b, candidate.b_in_a, points, weights);
    }
    if (how == Alignment::Free || aligned_score > candidate.score) {
      candidate = {aligned, aligned_score};
    }
  });
}

/// How far apart walls are, metres: free area over length of wall.
double wallSpacing(const MapFeatures& a, const MapFeatures& b) {
  double area = 0, wall = 0;
  for (const MapFeatures* map : {&a, &b}) {
    area += map->freeArea();
    wall += map->wallLength();
  }
  return area / std::max(wall, 1e-9);
}

/// All that the cells say of a transform.
Fit fitOf(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
          const RankingOptions& options, const EvidenceWeights& weights,
          const EvidenceWeights& bent_weights) {
  const auto points = static_cast<size_t>(options.bent_points);
  Fit fit;
  fit.b_in_a = b_in_a;
  fit.evidence = gatherEvidence(a, b, b_in_a, points, weights);
  fit.drift = estimateDrift(a, b, b_in_a, options.drift);
  fit.bent_evidence = gatherEvidence(a, b, b_in_a, fit.drift, points, bent_weights);
  return fit;
}

/// Fills in what the log odds are made of beside the evidence, and these.
void weighFit(const MapFeatures& a, const MapFeatures& b, Fit& fit) {
  fit.bend_ratio = bendRatio(a, b, fit.drift);
  fit.log_odds = logOdds(verdictTerms(fit));
}

/// Aligns the candidates, and adds those that are about as plausible as the best to the fits. Of
/// one answer the first fit stays, or, of careful alignment, the likelier one.
void addFits(const MapFeatures& a, const MapFeatures& b, std::vector<Ranked> ranked, Alignment how,
             const RankingOptions& options, const EvidenceWeights& weights,
             const EvidenceWeights& bent_weights, int threads, std::vector<Fit>& fits) {
  const Eigen::Vector2d centre_b = b.middle();
  for (const auto& [alignment, within] :
       {std::make_pair(options.first_alignment, options.aligned_within),
        std::make_pair(options.alignment, options.kept_within)}) {
    align(a, b, ranked, alignment, how, options, weights, threads);
    keepBest(ranked, options.aligned);
    keepDistinct(ranked, options.kept, centre_b, options);
    dropHopeless(ranked, within);
  }
  std::vector<Fit> fits_of_ranked(ranked.size());
  parallelFor(static_cast<int>(ranked.size()), threads, [&](int i) {
    const auto index = static_cast<size_t>(i);
    fits_of_ranked[index] = fitOf(a, b, ranked[index].b_in_a, options, weights, bent_weights);
  });
  for (Fit& fit : fits_of_ranked) {
    const auto same = std::find_if(fits.begin(), fits.end(), [&](const Fit& other) {
      return distanceWhenBent(a, b, fit, other) < options.same_bent;
    });
    if (same != fits.end() && how == Alignment::Free) {
      continue;
    }
    weighFit(a, b, fit);
    if (same == fits.end()) {
      fits.push_back(std::move(fit));
    } else if (fit.log_odds > same->log_odds) {
      *same = std::move(fit);
    }
  }
}

}  // namespace

std::vector<Fit> rankHypotheses(const MapFeatures& a, const MapFeatures& b,
                                const std::vector<Hypothesis>& hypotheses,
                                const RankingOptions& options, bool is_thorough, int threads) {
  std::vector<Ranked> ranked;
  ranked.reserve(hypotheses.size());
  for (const Hypothesis& hypothesis : hypotheses) {
    ranked.push_back({hypothesis.b_in_a, 0});
  }
  const EvidenceWeights weights(options.evidence), bent_weights(options.bent_evidence);
  score(a, b, ranked, options.first_points, weights, threads);
  keepBest(ranked, options.first_kept);
  score(a, b, ranked, options.coarse_points, weights, threads);
  keepBest(ranked, options.coarse_kept);
  score(a, b, ranked, options.fine_points, weights, threads);
  keepBest(ranked, options.coarse_kept);
  keepDistinct(ranked, options.aligned, b.middle(), options);

  std::vector<Fit> fits;
  addFits(a, b, ranked, Alignment::Free, options, weights, bent_weights, threads, fits);
  // Where walls stand nearer than the kernel reaches.
  if (is_thorough && wallSpacing(a, b) < options.alignment.kernel) {
    addFits(a, b, std::move(ranked), Alignment::Careful, options, weights, bent_weights, threads,
            fits);
  }
  return fits;
}

}  // namespace sbox
