// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/verification/verdict_model.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sbox {
namespace {

/// Share of the walls in the common area that agree; a few metres of wall do not make a large one.
double agreeShare(const Evidence& evidence) {
  constexpr double doubt = 10;  // Metres.
  return evidence.agree / (evidence.known + doubt);
}

}  // namespace

double crossWall(const Evidence& evidence) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(evidence.facing,
                                                              Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues()[0]);
}

std::array<double, kVerdictTerms> verdictTerms(const Fit& fit) {
  const Evidence& rigid = fit.evidence;
  const Evidence& bent = fit.bent_evidence;
  constexpr double least_drift = 0.05;  // Metres.
  return {agreeShare(bent),
          std::log(crossWall(bent) + 0.5),
          std::sqrt(bent.conflict),
          rigid.conflict / (bent.free_free + 10),
          bent.conflict / (bent.free_free + 10),
          std::sqrt(bent.free_free),
          std::log(bent.free_free / (bent.free + 1) + 0.02),
          std::log(fit.boxes + 1.0),
          std::log(static_cast<double>(fit.drift.displacements.size())),
          std::log1p(rigid.conflict / (fit.drift.roughness() + least_drift)),
          fit.bend_ratio};
}

double logOdds(const Fit& fit, const VerdictModel& model) {
  const std::array<double, kVerdictTerms> terms = verdictTerms(fit);
  return std::inner_product(terms.begin(), terms.end(), model.weights.begin(), 0.0);
}

void judge(std::vector<Fit>& fits, const VerdictModel& model) {
  double highest = model.none;
  for (Fit& fit : fits) {
    fit.log_odds = logOdds(fit, model);
    highest = std::max(highest, fit.log_odds);
  }
  double sum = std::exp(model.none - highest);
  for (const Fit& fit : fits) {
    sum += std::exp(fit.log_odds - highest);
  }
  for (Fit& fit : fits) {
    fit.probability = std::exp(fit.log_odds - highest) / sum;
  }
  std::stable_sort(fits.begin(), fits.end(), [](const Fit& left, const Fit& right) {
    return left.log_odds > right.log_odds;
  });
}

}  // namespace sbox
