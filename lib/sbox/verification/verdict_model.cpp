// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/verification/verdict_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sbox/core/logit.h"
#include "sbox/core/principal_axes.h"
#include "sbox/core/sort_descending.h"

namespace sbox {

double crossWall(const Evidence& evidence) {
  return std::max(0.0, principalAxes(evidence.facing).smallest);
}

std::array<double, kVerdictTerms> verdictTerms(const Fit& fit) {
  const Evidence& evidence = fit.bent_evidence;
  const WallSums& straight = evidence.straight;
  const WallSums clutter = {evidence.known - straight.known, evidence.agree - straight.agree,
                            evidence.conflict - straight.conflict};
  // A few metres of wall do not make a large share, nor a few square metres of area a small one.
  constexpr double few_metres = 10, few_square_metres = 5;
  const double area = evidence.free_shallow + few_square_metres;
  // The drift field follows clutter that moved, too, so there it tells little: 9 parts of bare wall
  // in 10 make 0.43 of this, 7 make 0.06. Of the powers tried, the one that fitted best.
  constexpr int power = 8;
  constexpr double few_rooms = 3;
  const double bareness = std::pow(1 - clutter.known / (evidence.known + few_metres), power);
  return {straight.agree / (straight.known + few_metres),
          std::log(clutter.agree + 1),
          std::log(crossWall(evidence) + 0.5),
          std::sqrt(evidence.deep_conflict),
          evidence.shallow_conflict / area,
          clutter.conflict / area,
          fit.bend_ratio * bareness,
          evidence.rooms.misfit / (evidence.rooms.all + few_rooms)};
}

double logOdds(const std::array<double, kVerdictTerms>& terms, const VerdictModel& model) {
  return std::inner_product(terms.begin(), terms.end(), model.weights.begin(), 0.0);
}

void judge(std::vector<Fit>& fits, const VerdictModel& model) {
  std::vector<double> log_odds;
  for (Fit& fit : fits) {
    fit.log_odds = logOdds(verdictTerms(fit), model);
    log_odds.push_back(fit.log_odds);
  }
  const std::vector<double> probabilities = probabilitiesByLogit(log_odds, model.none);
  for (size_t i = 0; i < fits.size(); ++i) {
    fits[i].probability = probabilities[i];
  }
  sortDescending(fits, [](const Fit& fit) { return fit.log_odds; });
}

}  // namespace sbox
