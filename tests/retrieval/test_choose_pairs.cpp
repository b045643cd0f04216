// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <random>

#include "catch.h"
#include "sbox/alignment/plausibility.h"
#include "sbox/retrieval/choose_pairs.h"

using namespace sbox;

namespace {

/// The definition, pair by pair: fewer than `partners` of one of its maps' pairs are more alike.
std::vector<PairIndex> chosenOneByOne(const std::vector<PairLikeness>& all, int partners) {
  std::vector<PairIndex> chosen;
  for (const PairLikeness& pair : all) {
    const auto more_alike = [&](int map) {
      return std::count_if(all.begin(), all.end(), [&](const PairLikeness& other) {
        const bool is_of_map = other.maps.first == map || other.maps.second == map;
        return is_of_map && std::isfinite(other.likeness) && other.likeness > pair.likeness;
      });
    };
    const bool is_near =
        more_alike(pair.maps.first) < partners || more_alike(pair.maps.second) < partners;
    if (pair.likeness > kImplausible && (is_near || std::isinf(pair.likeness))) {
      chosen.push_back(pair.maps);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<PairLikeness> randomLikeness(int maps, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<PairLikeness> all;
  for (const PairIndex& maps_of_pair : allPairs(maps)) {
    // Whole numbers, so that some are equal.
    double likeness = std::uniform_int_distribution<int>(0, 30)(random);
    likeness = likeness == 0 ? kImplausible : likeness;
    all.push_back(
        {maps_of_pair, likeness == 1 ? std::numeric_limits<double>::infinity() : likeness});
  }
  return all;
}

}  // namespace

TEST_CASE("every pair of four maps", "[choose_pairs]") {
  CHECK(allPairs(4) == std::vector<PairIndex>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}});
}

TEST_CASE("a pair is chosen if one of its maps wants it", "[choose_pairs]") {
  const std::vector<PairLikeness> all{{{0, 1}, 9}, {{0, 2}, 5}, {{0, 3}, 4},
                                      {{1, 2}, 6}, {{1, 3}, 1}, {{2, 3}, 2}};
  // The best of 0 and 1 is 0-1, of 2 it is 1-2, of 3 it is 0-3.
  CHECK(choosePairs(4, all, 1) == std::vector<PairIndex>{{0, 1}, {0, 3}, {1, 2}});
}

TEST_CASE("pairs of which nothing is known are chosen, implausible ones are not",
          "[choose_pairs]") {
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<PairLikeness> all{{{0, 1}, 3}, {{0, 2}, infinite}, {{1, 2}, kImplausible}};
  CHECK(choosePairs(3, all, 1) == std::vector<PairIndex>{{0, 1}, {0, 2}});
}

TEST_CASE("no number of partners means all pairs that are plausible", "[choose_pairs]") {
  const std::vector<PairLikeness> all{{{0, 1}, 3}, {{0, 2}, -7}, {{1, 2}, kImplausible}};
  CHECK(choosePairs(3, all, 0) == std::vector<PairIndex>{{0, 1}, {0, 2}});
}

TEST_CASE("choosing pairs agrees with its definition, in whatever order they come",
          "[choose_pairs]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::vector<PairLikeness> all = randomLikeness(12, seed);
    for (const int partners : {1, 3, 7}) {
      INFO("seed " << seed << ", partners " << partners);
      const std::vector<PairIndex> expected = chosenOneByOne(all, partners);
      CHECK(expected.size() < all.size());
      CHECK(choosePairs(12, all, partners) == expected);
      std::shuffle(all.begin(), all.end(), std::mt19937(seed));
      CHECK(choosePairs(12, all, partners) == expected);
    }
  }
}
