// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include "catch.h"
#include "sbox/verification/verdict.h"

using namespace sbox;

namespace {

/// Fits with these probabilities, on walls of which most agree and which fix every shift.
std::vector<Fit> fitsOf(const std::vector<double>& probabilities) {
  std::vector<Fit> fits;
  for (const double probability : probabilities) {
    Fit fit;
    fit.probability = probability;
    fit.bent_evidence.known = 100;
    fit.bent_evidence.agree = 90;
    fit.bent_evidence.conflict = 1;
    fit.bent_evidence.facing = 45 * Eigen::Matrix2d::Identity();
    fit.evidence = fit.bent_evidence;
    fits.push_back(fit);
  }
  return fits;
}

bool says(const Verdicted& verdicted, const std::string& words) {
  return verdicted.reason.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a fit that is probable enough is accepted", "[verification]") {
  VerdictOptions options;
  options.accept_from = 0.8;
  const Verdicted sure = decide(fitsOf({0.8, 0.01}), options);
  CHECK(sure.verdict == Verdict::Accepted);
  CHECK(says(sure, "90 m of wall agree, 90 %"));
  CHECK(decide(fitsOf({0.79, 0.005}), options).verdict == Verdict::Rejected);
  CHECK(decide(fitsOf({0.79}), options).verdict == Verdict::Rejected);
}

TEST_CASE("where one of several fits is right, but which is not told, that is said",
          "[verification]") {
  const Verdicted torn = decide(fitsOf({0.5, 0.4, 0.05}));
  CHECK(torn.verdict == Verdict::Ambiguous);
  CHECK(says(torn, "another transform"));
  CHECK(says(torn, "0.40 beside 0.50"));
  CHECK(decide(fitsOf({0.2, 0.2})).verdict == Verdict::Rejected);
}

TEST_CASE("a rival with nothing against it keeps the best from being accepted", "[verification]") {
  VerdictOptions options;
  options.accept_from = 0.8;
  options.rival_from = 0.1;
  options.rival_agree = 0.85;
  options.rival_conflict = 0.02;
  std::vector<Fit> fits = fitsOf({0.85, 0.12});
  CHECK(decide(fits, options).verdict == Verdict::Ambiguous);
  // The reason tells of the rival, not of a more probable fit that much speaks against.
  fits = fitsOf({0.8, 0.14, 0.11});
  fits[1].evidence.conflict = 30;
  const Verdicted torn = decide(fits, options);
  CHECK(torn.verdict == Verdict::Ambiguous);
  CHECK(says(torn, "0.11 beside 0.80"));
  // What speaks against it.
  fits = fitsOf({0.85, 0.12});
  fits[1].evidence.conflict = 3;
  CHECK(decide(fits, options).verdict == Verdict::Accepted);
  fits = fitsOf({0.85, 0.12});
  fits[1].evidence.agree = 80;
  CHECK(decide(fits, options).verdict == Verdict::Accepted);
  fits = fitsOf({0.85, 0.12});
  fits[1].evidence.known = 42;
  fits[1].evidence.agree = 40;
  CHECK(decide(fits, options).verdict == Verdict::Accepted);
  // Or it is not probable.
  CHECK(decide(fitsOf({0.85, 0.09}), options).verdict == Verdict::Accepted);
}

TEST_CASE("a refusal says what is missing", "[verification]") {
  CHECK(decide({}).verdict == Verdict::Rejected);
  CHECK(says(decide({}), "no way to lay the maps over each other"));

  std::vector<Fit> fits = fitsOf({0.2});
  CHECK(says(decide(fits), "too little in common"));
  fits[0].bent_evidence.deep_conflict = 7;
  CHECK(says(decide(fits), "7 m of wall stand far out in what the other map saw as free"));
  fits[0].bent_evidence.conflict = 30;
  CHECK(says(decide(fits), "saw free space"));
  fits[0].bent_evidence.facing(1, 1) = 0.5;
  CHECK(says(decide(fits), "nothing fixes the shift along the walls"));
  CHECK(says(decide(fits), "0.5 m of agreeing wall run across"));
  fits[0].bent_evidence.agree = 20;
  CHECK(says(decide(fits), "too few walls agree"));
  // Nothing known is nothing to divide by.
  fits[0].bent_evidence = Evidence();
  const Verdicted nothing = decide(fits);
  CHECK(nothing.verdict == Verdict::Rejected);
  CHECK_FALSE(says(nothing, "nan"));
}
