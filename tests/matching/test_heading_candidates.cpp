// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/matching/heading_candidates.h"

using namespace sbox;

namespace {

constexpr double kDegree = M_PI / 180;

/// Walls of a building with a few directions of its own, in degrees, that face either side.
std::vector<double> facings(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0, 360);
  const std::vector<double> directions{any(random), any(random), any(random)};
  std::normal_distribution<double> noise(0, 2);
  std::vector<double> degrees;
  for (int i = 0; i < count; ++i) {
    // Of the first direction there is most, so that no other heading does as well.
    const auto kind = static_cast<size_t>(std::discrete_distribution<int>({5, 3, 2})(random));
    degrees.push_back(directions[kind] + noise(random));
  }
  return degrees;
}

MapFeatures facing(const std::vector<double>& degrees) {
  MapFeatures map;
  for (const double angle : degrees) {
    map.wall_points.push_back({{0, 0}, {std::cos(angle * kDegree), std::sin(angle * kDegree)}});
  }
  return map;
}

/// How well walls face each other's way once b is turned: each pair of walls by itself.
double correlationOfAllPairs(const std::vector<double>& a, const std::vector<double>& b,
                             double turn, double smoothing) {
  double sum = 0;
  for (const double in_a : a) {
    for (const double in_b : b) {
      const double off = std::remainder(in_b + turn - in_a, 360);
      // Both histograms are smoothed.
      sum += std::exp(-0.25 * off * off / (smoothing * smoothing));
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("headings are those at which most pairs of walls face the same way", "[matching]") {
  const HeadingOptions options;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto in_a = facings(seed, 150), in_b = facings(seed + 40, 120);
    const std::vector<double> found = findHeadings(facing(in_a), facing(in_b), options);
    REQUIRE(!found.empty());
    INFO("seed " << seed);
    const auto correlation = [&](double degrees) {
      return correlationOfAllPairs(in_a, in_b, degrees, options.smoothing);
    };
    double best = 0;
    for (int turn = 0; turn < 360; ++turn) {
      best = std::max(best, correlation(turn));
    }
    const double first = found[0] / kDegree;
    CHECK(correlation(first) > 0.95 * best);
    // A step of the lattice is told by the first heading.
    for (int i = 0; i < 90; ++i) {
      const double turn = first + i * options.step;
      const bool is_found = std::any_of(found.begin(), found.end(), [&](double heading) {
        return std::abs(std::remainder(heading / kDegree - turn, 360)) < 0.6;
      });
      const double share = correlation(turn) / best;
      INFO("turn " << turn << " share " << share);
      CHECK(
          (std::abs(share - options.min_share) < 0.08 || is_found == (share > options.min_share)));
    }
    for (size_t i = 1; i < found.size(); ++i) {
      CHECK(correlation(found[i] / kDegree) < 1.08 * correlation(found[i - 1] / kDegree));
    }
  }
}

TEST_CASE("a turned map is found at its turn", "[matching]") {
  for (const double turn : {0.0, 37.0, 190.0, 355.0}) {
    const auto in_a = facings(3, 300);
    std::vector<double> in_b;
    for (const double angle : in_a) {
      in_b.push_back(angle - turn);
    }
    const auto found = findHeadings(facing(in_a), facing(in_b));
    REQUIRE(!found.empty());
    CHECK(std::abs(std::remainder(found[0] / kDegree - turn, 360)) < 1.5);
  }
}

TEST_CASE("no more headings than asked for, and none without walls", "[matching]") {
  std::vector<double> all_round;
  for (int i = 0; i < 720; ++i) {
    all_round.push_back(0.5 * i);
  }
  HeadingOptions options;
  CHECK(findHeadings(facing(all_round), facing(all_round), options).size() ==
        static_cast<size_t>(options.max_headings));
  options.max_headings = 1000;
  // A round hall fits at any: every step of the lattice.
  CHECK(findHeadings(facing(all_round), facing(all_round), options).size() == 90);
  CHECK(findHeadings(facing({}), facing(all_round)).empty());
  CHECK(findHeadings(facing(all_round), facing({})).empty());
}
