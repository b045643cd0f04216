// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/verification/verdict_model.h"

using namespace sbox;

namespace {

/// Evidence such as real maps give.
std::vector<Fit> randomFits(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<Fit> fits;
  for (int i = 0; i < count; ++i) {
    Fit fit;
    for (Evidence* evidence : {&fit.evidence, &fit.bent_evidence}) {
      evidence->known = between(10, 200);
      evidence->agree = between(0, 1) * evidence->known;
      evidence->conflict = between(0, 0.3) * evidence->known;
      const double straight = between(0, 1);
      evidence->straight = {straight * evidence->known, straight * evidence->agree,
                            straight * evidence->conflict};
      evidence->shallow_conflict = between(0, 1) * evidence->straight.conflict;
      evidence->deep_conflict = evidence->straight.conflict - evidence->shallow_conflict;
      evidence->free_free = between(0, 400);
      evidence->free_shallow = between(0, 1) * evidence->free_free;
      const double share = between(0, 1);
      evidence->facing =
          Eigen::Vector2d(share * evidence->agree, (1 - share) * evidence->agree).asDiagonal();
    }
    fit.bend_ratio = between(0, 4);
    fit.bent_evidence.rooms.all = between(0, 20);
    fit.bent_evidence.rooms.misfit = between(0, 1) * fit.bent_evidence.rooms.all;
    fits.push_back(fit);
  }
  return fits;
}

}  // namespace

TEST_CASE("probabilities are those of a logit over all fits and none", "[verification]") {
  const VerdictModel model;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::vector<Fit> fits = randomFits(seed, 8);
    judge(fits, model);
    REQUIRE(fits.size() == 8);
    long double sum = std::exp(static_cast<long double>(model.none));
    for (const Fit& fit : fits) {
      const auto terms = verdictTerms(fit);
      double log_odds = 0;
      for (size_t i = 0; i < terms.size(); ++i) {
        CHECK(std::isfinite(terms[i]));
        log_odds += model.weights[i] * terms[i];
      }
      CHECK(fit.log_odds == Approx(log_odds));
      sum += std::exp(static_cast<long double>(log_odds));
    }
    for (size_t i = 0; i < fits.size(); ++i) {
      const auto share = std::exp(static_cast<long double>(fits[i].log_odds)) / sum;
      CHECK(fits[i].probability == Approx(static_cast<double>(share)).margin(1e-12));
      CHECK((i == 0 || fits[i].log_odds <= fits[i - 1].log_odds));
    }
  }
}

TEST_CASE("odds beyond what a double's exponent holds are still compared", "[verification]") {
  VerdictModel model;
  model.weights.fill(0);
  model.weights[0] = 1e5;
  std::vector<Fit> fits = randomFits(1, 1);
  fits.push_back(fits[0]);
  judge(fits, model);
  CHECK(fits[0].probability == Approx(0.5));
  CHECK(fits[1].probability == Approx(0.5));
  model.none = 1e6;
  judge(fits, model);
  CHECK(fits[0].probability == 0);
  std::vector<Fit> none;
  judge(none, model);
  CHECK(none.empty());
}

TEST_CASE("straight wall in conflict says more than as much clutter", "[verification]") {
  const Fit fit = randomFits(3, 1).front();
  std::vector<Fit> fits{fit, fit, fit};
  constexpr double metres = 5;
  fits[1].bent_evidence.conflict += metres;
  fits[2].bent_evidence.conflict += metres;
  fits[2].bent_evidence.straight.conflict += metres;
  fits[2].bent_evidence.shallow_conflict += metres;
  for (size_t i = 0; i + 1 < fits.size(); ++i) {
    CHECK(logOdds(verdictTerms(fits[i])) > logOdds(verdictTerms(fits[i + 1])));
  }
}

TEST_CASE("a wall that no drift has carried there says more than one that it may have",
          "[verification]") {
  Fit shallow = randomFits(3, 1).front();
  shallow.bent_evidence.free_shallow = 200;
  Fit deep = shallow;
  shallow.bent_evidence.shallow_conflict += 5;
  deep.bent_evidence.deep_conflict += 5;
  CHECK(logOdds(verdictTerms(shallow)) > logOdds(verdictTerms(deep)) + std::log(5));
}

TEST_CASE("conflict is not made small by the middle of a hall", "[verification]") {
  Fit rooms = randomFits(3, 1).front();
  rooms.bent_evidence.free_free = rooms.bent_evidence.free_shallow = 100;
  Fit hall = rooms;
  hall.bent_evidence.free_free = 500;
  CHECK(logOdds(verdictTerms(hall)) == logOdds(verdictTerms(rooms)));
  hall.bent_evidence.free_shallow = 500;
  CHECK(logOdds(verdictTerms(hall)) > logOdds(verdictTerms(rooms)));
}

TEST_CASE("a fit more bent than its maps is less probable where walls are bare", "[verification]") {
  Fit bare = randomFits(3, 1).front();
  bare.bent_evidence.straight = bare.bent_evidence;
  Fit cluttered = bare;
  cluttered.bent_evidence.straight = {};
  const auto fallsBy = [](Fit fit) {
    fit.bend_ratio = 0.5;
    const double before = logOdds(verdictTerms(fit));
    fit.bend_ratio = 2.5;
    return before - logOdds(verdictTerms(fit));
  };
  CHECK(fallsBy(bare) > std::log(100));
  CHECK(fallsBy(cluttered) >= 0);
  CHECK(fallsBy(cluttered) < 0.1);
}

TEST_CASE("conflict that lies together counts less than strewn all over", "[verification]") {
  Fit fit = randomFits(5, 1).front();
  fit.bent_evidence.rooms = {12, 0};
  const double strewn = logOdds(verdictTerms(fit));
  fit.bent_evidence.rooms = {12, 4};
  CHECK(logOdds(verdictTerms(fit)) > strewn);
}

TEST_CASE("two equal fits are equally probable, a third takes from both", "[verification]") {
  std::vector<Fit> one = randomFits(3, 1);
  VerdictModel model;
  model.none = -1e3;
  judge(one, model);
  CHECK(one[0].probability == Approx(1));
  std::vector<Fit> two{one[0], one[0]};
  judge(two, model);
  CHECK(two[0].probability == Approx(0.5));
  CHECK(two[1].probability == Approx(0.5));
}

TEST_CASE("a fit without any evidence has terms that can be reckoned with", "[verification]") {
  for (const double term : verdictTerms(Fit())) {
    CHECK(std::isfinite(term));
  }
}

TEST_CASE("the cross wall is what fixes the shift that is fixed least", "[verification]") {
  Evidence evidence;
  CHECK(crossWall(evidence) == 0);
  // 30 m of wall that face one way and 4 m that face square to it, in turned maps.
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.6).toRotationMatrix();
  evidence.facing = turn * Eigen::Vector2d(30, 4).asDiagonal() * turn.transpose();
  CHECK(crossWall(evidence) == Approx(4));
  evidence.facing = turn * Eigen::Vector2d(30, 0).asDiagonal() * turn.transpose();
  CHECK(crossWall(evidence) == Approx(0).margin(1e-9));
}
