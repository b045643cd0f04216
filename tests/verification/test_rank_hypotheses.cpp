// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "drawing.h"
#include "sbox/alignment/plausibility.h"
#include "sbox/matching/feature_votes.h"
#include "sbox/verification/rank_hypotheses.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

struct Pair {
  MapFeatures a, b;
  RigidTransform b_in_a;  ///< The truth.
};

/// Two robots that saw the west and the east of one floor.
Pair halvesOf(unsigned seed) {
  const test::Floor floor = test::randomFloor(seed);
  const Pose2D a_in_world(1, -2, 0.4), b_in_world(5, 1, -1.3);
  Pair pair;
  pair.a = extractFeatures(test::exploreMap(floor, a_in_world, 0.1, {{-1, -1}, {15, 20}}));
  pair.b = extractFeatures(test::exploreMap(floor, b_in_world, 0.1, {{4, -1}, {40, 20}}));
  const Pose2D truth =
      inverse(pair.a.grid_in_map) + inverse(a_in_world) + b_in_world + pair.b.grid_in_map;
  pair.b_in_a = {truth.phi, {truth.x, truth.y}};
  return pair;
}

/// What features propose, and hypotheses about the truth and anywhere.
std::vector<Hypothesis> hypothesesFor(const Pair& pair, unsigned seed) {
  std::vector<Hypothesis> hypotheses = voteForTransforms(pair.a, pair.b);
  hypotheses.resize(std::min<size_t>(hypotheses.size(), 250));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI), shift(-15, 15);
  for (int i = 0; i < 50; ++i) {
    const double heading = angle(random);
    const Vector2d place = pair.a.middle() + Vector2d(shift(random), shift(random));
    hypotheses.push_back({{heading, place - Eigen::Rotation2Dd(heading) * pair.b.middle()}, 0});
  }
  return hypotheses;
}

/// A store full of crates, half of which stand elsewhere the second time.
Pair storeOf(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto crates = [&](test::Floor& floor, int count) {
    for (int i = 0; i < count; ++i) {
      const double x = between(1, 13), y = between(1, 9), size = between(0.3, 0.7);
      const auto walls = test::wallsRound(
          {{x, y}, {x + size, y + 0.2}, {x + size - 0.2, y + size}, {x - 0.2, y + size - 0.2}});
      floor.walls.insert(floor.walls.end(), walls.begin(), walls.end());
    }
  };
  test::Floor fixed{test::wallsRound({{0, 0}, {14, 0}, {14, 10}, {0, 10}}), {{0.5, 0.5}}};
  crates(fixed, 60);
  const auto seen = [&](double first, double last) {
    test::Floor floor = fixed;
    crates(floor, 40);
    return extractFeatures(test::exploreMap(floor, {}, 0.1, {{first, 0.3}, {last, 9.7}}));
  };
  Pair pair;
  pair.a = seen(0.4, 10);
  pair.b = seen(4, 13.6);
  pair.b_in_a.translation = Vector2d(pair.b.grid_in_map.x - pair.a.grid_in_map.x,
                                     pair.b.grid_in_map.y - pair.a.grid_in_map.y);
  return pair;
}

/// Whether two transforms put the middle of a map within `distance` (metres) of each other and turn
/// it within `turn` (radians).
bool areNear(const RigidTransform& left, const RigidTransform& right, const Vector2d& middle,
             double distance, double turn) {
  return (left * middle - right * middle).norm() < distance &&
         std::abs(std::remainder(left.heading - right.heading, 2 * M_PI)) < turn;
}

bool isSame(const RigidTransform& left, const RigidTransform& right) {
  return left.heading == right.heading && left.translation == right.translation;
}

}  // namespace

TEST_CASE("asking few points first loses no answer that asking all finds", "[verification]") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Pair pair = halvesOf(seed);
    const auto hypotheses = hypothesesFor(pair, seed);
    const RankingOptions options;
    const auto fits = rankHypotheses(pair.a, pair.b, hypotheses, options);
    INFO("seed " << seed);
    REQUIRE(!fits.empty());

    // Every hypothesis is aligned and asked of all points.
    RigidTransform best;
    double highest = kImplausible;
    for (const Hypothesis& hypothesis : hypotheses) {
      const RigidTransform aligned =
          alignWalls(pair.a, pair.b, hypothesis.b_in_a, options.alignment);
      const double found = plausibility(gatherEvidence(pair.a, pair.b, aligned));
      if (found > highest) {
        highest = found;
        best = aligned;
      }
    }
    CHECK(areNear(fits[0].b_in_a, best, pair.b.middle(), 0.3, 0.02));
    CHECK(areNear(fits[0].b_in_a, pair.b_in_a, pair.b.middle(), 0.3, 0.02));
    CHECK(plausibility(gatherEvidence(pair.a, pair.b, fits[0].b_in_a)) > highest - 1);
  }
}

TEST_CASE("fits are distinct, and carry what the cells say of them", "[verification]") {
  const Pair pair = halvesOf(2);
  const RankingOptions options;
  const auto fits = rankHypotheses(pair.a, pair.b, hypothesesFor(pair, 2), options);
  CHECK(fits.size() <= static_cast<size_t>(options.kept));
  for (size_t i = 0; i < fits.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      CHECK_FALSE(areNear(fits[i].b_in_a, fits[j].b_in_a, pair.b.middle(), options.same_distance,
                          options.same_turn * M_PI / 180));
    }
    const auto points = static_cast<size_t>(options.bent_points);
    CHECK(fits[i].evidence.agree ==
          gatherEvidence(pair.a, pair.b, fits[i].b_in_a, points, options.evidence).agree);
    CHECK(fits[i].bent_evidence.rooms.all > 0);
  }
}

TEST_CASE("the order of the hypotheses does not change the fits", "[verification]") {
  const Pair pair = halvesOf(3);
  auto hypotheses = hypothesesFor(pair, 3);
  const auto fits = rankHypotheses(pair.a, pair.b, hypotheses);
  std::shuffle(hypotheses.begin(), hypotheses.end(), std::mt19937(9));
  const auto shuffled = rankHypotheses(pair.a, pair.b, hypotheses);
  REQUIRE(fits.size() == shuffled.size());
  for (size_t i = 0; i < fits.size(); ++i) {
    CHECK(isSame(fits[i].b_in_a, shuffled[i].b_in_a));
  }
}

TEST_CASE("among clutter, a thorough ranking keeps a good start that a wide kernel leaves",
          "[verification]") {
  double wide = 0, thorough = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const Pair pair = storeOf(seed);
    // How far the nearest fit is from the truth.
    const auto offBy = [&](bool is_thorough) {
      double least = 1e9;
      for (const Fit& fit : rankHypotheses(pair.a, pair.b, {{pair.b_in_a, 0}}, {}, is_thorough)) {
        const Vector2d middle = pair.b.middle();
        least = std::min(least, (fit.b_in_a * middle - pair.b_in_a * middle).norm());
      }
      return least;
    };
    wide += offBy(false);
    thorough += offBy(true);
  }
  CHECK(thorough < 0.7 * wide);
}

TEST_CASE("of nothing, and of maps that do not meet, there are no fits", "[verification]") {
  const Pair pair = halvesOf(1);
  CHECK(rankHypotheses(pair.a, pair.b, {}).empty());
  CHECK(rankHypotheses(pair.a, pair.b, {{{0, {1000, 0}}, 5}, {{1, {0, -1000}}, 3}}).empty());
}
