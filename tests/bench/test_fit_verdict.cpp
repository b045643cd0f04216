// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox-bench/cross_validation.h"
#include "sbox-bench/fit_verdict.h"

using namespace sbox;
using namespace sbox::bench;

namespace {

/// Pairs of four fits each, whose right one (or none) is drawn by the model itself.
std::vector<VerdictSample> drawnBy(const VerdictModel& model, size_t count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<VerdictSample> samples(count);
  for (size_t i = 0; i < count; ++i) {
    samples[i].folder = i % 2;
    samples[i].terms.resize(4);
    samples[i].right.assign(4, false);
    for (auto& terms : samples[i].terms) {
      for (double& term : terms) {
        term = normal(random);
      }
    }
    double left = uniform(random);
    const std::vector<double> p = probabilities(samples[i], model);
    for (size_t k = 0; k < p.size() && left >= 0; ++k) {
      left -= p[k];
      samples[i].right[k] = left < 0;
    }
  }
  return samples;
}

VerdictModel knownModel() {
  VerdictModel model;
  model.weights = {2, 1, -1, -0.5, 0, 0.5, 1.5, -0.7};
  model.none = 1;
  return model;
}

}  // namespace

TEST_CASE("the fit finds the model that drew the samples") {
  const VerdictModel model = fitModel(drawnBy(knownModel(), 6000), 0);
  for (size_t i = 0; i < kVerdictTerms; ++i) {
    CHECK(model.weights[i] == Approx(knownModel().weights[i]).margin(0.15));
  }
  CHECK(model.none == Approx(1).margin(0.15));
}

TEST_CASE("a ridge makes weights smaller, and no right fit makes \"none\" likely") {
  const std::vector<VerdictSample> samples = drawnBy(knownModel(), 600);
  CHECK(std::abs(fitModel(samples, 0.3).weights[0]) < std::abs(fitModel(samples, 0).weights[0]));
  std::vector<VerdictSample> never = samples;
  for (VerdictSample& sample : never) {
    sample.right.assign(4, false);
  }
  const std::vector<double> p = probabilities(never[0], fitModel(never));
  CHECK(p[0] + p[1] + p[2] + p[3] < 0.05);
}

TEST_CASE("a folder that weighs nothing changes no model") {
  const std::vector<VerdictSample> half = drawnBy(knownModel(), 200);
  std::vector<VerdictSample> even, weighed;
  for (VerdictSample sample : half) {
    if (sample.folder == 0) {
      even.push_back(sample);
    } else {
      sample.right.assign(4, false);
      sample.folder_weight = 0;
    }
    weighed.push_back(sample);
  }
  const VerdictModel expected = fitModel(even), model = fitModel(weighed);
  // Terms are scaled by all samples before the ridge is laid on them.
  CHECK(model.none == Approx(expected.none).margin(0.05));
  CHECK(model.weights[0] == Approx(expected.weights[0]).margin(0.05));
}

TEST_CASE("cross-validation counts each pair once") {
  const Table table = crossValidation(drawnBy(knownModel(), 300), {"even", "odd"}, 0.7);
  REQUIRE(table.rows.size() > 2);
  CHECK(table.rows[0][1] == "150");
  CHECK(table.rows[1][1] == "150");
  int in_bins = 0;
  for (size_t row = 2; row < table.rows.size(); ++row) {
    in_bins += std::stoi(table.rows[row][1]);
  }
  CHECK(in_bins == 300);
}
