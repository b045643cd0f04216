// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/verification/verdict.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sbox {
namespace {

// Conditional logit model, fitted by maximum likelihood; CONTRIBUTING.md tells on what.
constexpr double kNone = 13.976;  ///< Log odds of "none of the fits is right".
constexpr double kAgreeShare = 20.634;
constexpr double kCrossWall = 0.936;
constexpr double kRigidConflict = -0.2173;
constexpr double kBentConflict = -0.3587;
constexpr double kConflictDensity = -10.255;
constexpr double kFreeLength = 0.3483;
constexpr double kFreeShare = 0.7715;
constexpr double kBoxes = 0.4869;

/// Agreeing wall that fixes the shift in the direction that is fixed least, metres.
double crossWall(const Evidence& evidence) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(evidence.facing,
                                                              Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues()[0]);
}

/// Share of the walls in the common area that agree; a few metres of wall do not make a large one.
double agreeShare(const Evidence& evidence) {
  constexpr double doubt = 10;  // Metres.
  return evidence.agree / (evidence.known + doubt);
}

double logOdds(const Fit& fit) {
  const Evidence& rigid = fit.evidence;
  const Evidence& bent = fit.bent_evidence;
  return kAgreeShare * agreeShare(bent) + kCrossWall * std::log(crossWall(bent) + 0.5) +
         kRigidConflict * std::sqrt(rigid.conflict) + kBentConflict * std::sqrt(bent.conflict) +
         kConflictDensity * rigid.conflict / (bent.free_free + 10) +
         kFreeLength * std::sqrt(bent.free_free) +
         kFreeShare * std::log(bent.free_free / (bent.free + 1) + 0.02) +
         kBoxes * std::log(fit.boxes + 1.0);
}

std::string text(const char* format, double first, double second = 0, double third = 0) {
  char buffer[240];
  std::snprintf(buffer, sizeof buffer, format, first, second, third);
  return buffer;
}

std::string describeAgreement(const Evidence& evidence) {
  return text("%.0f m of wall agree, %.0f %% of what lies in the common area, and %.1f m conflict",
              evidence.agree, 100 * evidence.agree / std::max(evidence.known, 1e-9),
              evidence.conflict);
}

std::string whyNot(const Fit& best) {
  const Evidence& bent = best.bent_evidence;
  const std::string found = describeAgreement(bent);
  if (bent.agree < 0.6 * bent.known) {
    return "too few walls agree: " + found;
  }
  if (crossWall(bent) < 4) {
    return text(
               "nothing fixes the shift along the walls: only %.1f m of agreeing wall run across "
               "the others; ",
               crossWall(bent)) +
           found;
  }
  if (bent.conflict > 0.12 * bent.known) {
    return "too much wall stands where the other map saw free space: " + found;
  }
  return "too little in common to be sure: " + found;
}

}  // namespace

void judge(std::vector<Fit>& fits) {
  double highest = kNone;
  for (Fit& fit : fits) {
    fit.log_odds = logOdds(fit);
    highest = std::max(highest, fit.log_odds);
  }
  double sum = std::exp(kNone - highest);
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

Verdicted decide(const std::vector<Fit>& fits, const VerdictOptions& options) {
  if (fits.empty()) {
    return {Verdict::Rejected, "no way to lay the maps over each other has walls in common"};
  }
  const Fit& best = fits.front();
  if (best.probability >= options.accept_from) {
    return {Verdict::Accepted, describeAgreement(best.bent_evidence)};
  }
  double any = 0;
  for (const Fit& fit : fits) {
    any += fit.probability;
  }
  if (fits.size() > 1 && any >= options.accept_from) {
    return {Verdict::Ambiguous,
            text("another transform explains the maps about as well (probability %.2f beside "
                 "%.2f): ",
                 fits[1].probability, best.probability) +
                describeAgreement(best.bent_evidence)};
  }
  return {Verdict::Rejected, whyNot(best)};
}

}  // namespace sbox
