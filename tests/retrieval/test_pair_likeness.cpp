// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.h"
#include "drawing.h"
#include "sbox/alignment/plausibility.h"
#include "sbox/retrieval/pair_likeness.h"
#include "scattered_map.h"

using namespace sbox;

namespace {

/// The whole of a random floor, seen from some pose.
MapFeatures floorSeenFrom(unsigned seed, const Pose2D& pose) {
  return extractFeatures(test::exploreMap(test::randomFloor(seed), pose, 0.1));
}

}  // namespace

TEST_CASE("maps of one floor are more alike than maps of different floors", "[pair_likeness]") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const MapFeatures a = floorSeenFrom(seed, {});
    const double alike = pairLikeness(a, floorSeenFrom(seed, {3, -2, 1.1}));
    for (unsigned other = 1; other <= 5; ++other) {
      if (other != seed) {
        INFO("floors " << seed << " and " << other);
        CHECK(alike > pairLikeness(a, floorSeenFrom(other, {1, 2, 0.4})));
      }
    }
  }
}

TEST_CASE("likeness is the plausibility of the best transform that has votes", "[pair_likeness]") {
  const MapFeatures one = floorSeenFrom(1, {}), other = floorSeenFrom(1, {3, -2, 1.1});
  const bool swaps = comesFirst(other, one);
  const MapFeatures &a = swaps ? other : one, &b = swaps ? one : other;
  const LikenessOptions all{50, 2, 300, 1000, 300};
  VoteOptions narrow_votes;
  narrow_votes.bin = 0.2;
  for (const VoteOptions& votes : {VoteOptions(), narrow_votes}) {
    for (const EvidenceOptions& evidence : {EvidenceOptions(), EvidenceOptions{0.05, 0.1, 0.3}}) {
      VoteOptions asked = votes;
      asked.max_hypotheses = all.max_hypotheses;
      asked.min_per_heading = all.min_per_heading;
      double best = kImplausible;
      for (const Hypothesis& hypothesis : voteForTransforms(a, b, asked)) {
        best = std::max(best, plausibility(measureOverlap(a, b, hypothesis.b_in_a, 300, evidence)));
      }
      CHECK(pairLikeness(one, other, all, votes, evidence) == best);
      if (votes.bin != VoteOptions().bin || evidence.kernel != EvidenceOptions().kernel) {
        CHECK(best != pairLikeness(one, other, all));
      }
    }
  }
}

TEST_CASE("likeness does not depend on the order of the maps", "[pair_likeness]") {
  const MapFeatures a = floorSeenFrom(1, {}), b = floorSeenFrom(2, {1, 2, 0.4});
  CHECK(pairLikeness(a, b) == pairLikeness(b, a));
  CHECK(std::isfinite(pairLikeness(a, b)));
}

TEST_CASE("a map without corners is unlike nothing", "[pair_likeness]") {
  const MapFeatures cornerless = test::scatteredMap(1).features;
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(pairLikeness(cornerless, floorSeenFrom(1, {})) == infinite);
  CHECK(pairLikeness(floorSeenFrom(1, {}), cornerless) == infinite);
}
