// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/verification/verdict.h"

#include <algorithm>
#include <cstdio>

#include "sbox/verification/verdict_model.h"

namespace sbox {
namespace {

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

/// Whether all that the maps have in common under this fit fits, and not much less than under the
/// best: then only the size of the overlap speaks for the best.
bool hasNothingAgainst(const Fit& rival, const Fit& best, const VerdictOptions& options) {
  const Evidence& evidence = rival.evidence;
  return rival.probability >= options.rival_from &&
         evidence.agree > options.rival_agree * evidence.known &&
         evidence.conflict < options.rival_conflict * evidence.known &&
         evidence.agree > 0.5 * best.evidence.agree;
}

}  // namespace

Verdicted decide(const std::vector<Fit>& fits, const VerdictOptions& options) {
  if (fits.empty()) {
    return {Verdict::Rejected, "no way to lay the maps over each other has walls in common"};
  }
  const Fit& best = fits.front();
  const bool is_rivalled = std::any_of(fits.begin() + 1, fits.end(), [&](const Fit& fit) {
    return hasNothingAgainst(fit, best, options);
  });
  if (best.probability >= options.accept_from && !is_rivalled) {
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
