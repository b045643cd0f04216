// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/verification/verdict.h"

#include <algorithm>
#include <string>

#include "sbox/core/number_text.h"
#include "sbox/verification/verdict_model.h"

namespace sbox {
namespace {

/// What makes the reason for a refusal, the first that holds.
constexpr double kFewAgree = 0.6;       ///< Less of the common wall than this agrees.
constexpr double kLeastCrossWall = 4;   ///< Fewer metres of agreeing wall run across the others.
constexpr double kMuchConflict = 0.12;  ///< More of the common wall than this conflicts.
constexpr double kMuchDeep = 5;  ///< More metres of wall lie where no drift has carried them.
/// Of the wall that agrees under the best fit, what a rival must have at least.
constexpr double kRivalSize = 0.5;

std::string describeAgreement(const Evidence& evidence) {
  const double share = evidence.agree / std::max(evidence.known, 1e-9);
  return fixedDigits(evidence.agree, 0) + " m of wall agree, " + fixedDigits(100 * share, 0) +
         " % of what lies in the common area, and " + fixedDigits(evidence.conflict, 1) +
         " m conflict";
}

std::string whyNot(const Fit& best) {
  const Evidence& bent = best.bent_evidence;
  const std::string found = describeAgreement(bent);
  if (bent.agree < kFewAgree * bent.known) {
    return "too few walls agree: " + found;
  }
  if (crossWall(bent) < kLeastCrossWall) {
    return "nothing fixes the shift along the walls: only " + fixedDigits(crossWall(bent), 1) +
           " m of agreeing wall run across the others; " + found;
  }
  if (bent.conflict > kMuchConflict * bent.known) {
    return "too much wall stands where the other map saw free space: " + found;
  }
  if (bent.deep_conflict > kMuchDeep) {
    return fixedDigits(bent.deep_conflict, 0) +
           " m of wall stand far out in what the other map saw as free: " + found;
  }
  return "too little in common to be sure: " + found;
}

/// Whether all that the maps have in common under this fit fits, and not much less than under the
/// best: then only the size of the overlap speaks for the best.
bool hasNothingAgainst(const Fit& rival, const Fit& best, const VerdictOptions& options) {
  const Evidence& evidence = rival.evidence;
  return rival.probability >= options.rival_from &&
         evidence.agree > options.rival_agree * evidence.known &&
         evidence.conflict < options.rival_conflict * evidence.known &&
         evidence.agree > kRivalSize * best.evidence.agree;
}

}  // namespace

Verdicted decide(const std::vector<Fit>& fits, const VerdictOptions& options) {
  if (fits.empty()) {
    return {Verdict::Rejected, "no way to lay the maps over each other has walls in common"};
  }
  const Fit& best = fits.front();
  const auto rival = std::find_if(fits.begin() + 1, fits.end(), [&](const Fit& fit) {
    return hasNothingAgainst(fit, best, options);
  });
  if (best.probability >= options.accept_from && rival == fits.end()) {
    return {Verdict::Accepted, describeAgreement(best.bent_evidence)};
  }
  double any = 0;
  for (const Fit& fit : fits) {
    any += fit.probability;
  }
  if (fits.size() > 1 && any >= options.accept_from) {
    const Fit& other = rival == fits.end() ? fits[1] : *rival;
    return {Verdict::Ambiguous, "another transform explains the maps about as well (probability " +
                                    fixedDigits(other.probability, 2) + " beside " +
                                    fixedDigits(best.probability, 2) +
                                    "): " + describeAgreement(best.bent_evidence)};
  }
  return {Verdict::Rejected, whyNot(best)};
}

}  // namespace sbox
