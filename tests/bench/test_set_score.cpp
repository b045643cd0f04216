// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox-bench/set_score.h"

using namespace sbox::bench;

TEST_CASE("three maps of one building are one group with all pairs right") {
  const PairFolder folder = readPairFolder(SBOX_DATASETS "/sena");
  const std::vector<MapSet> sets = readSets(folder);
  REQUIRE(sets.size() == 1);
  CHECK(sets[0].maps.size() == 3);
  SetScore score = scoreSet(folder, sets[0], 1);
  CHECK(score.groups == 1);
  CHECK(score.right == folder.pairs.size());
  // The same answers are wrong once the annotation lies elsewhere.
  PairFolder moved = folder;
  for (AnnotatedPair& pair : moved.pairs) {
    for (sbox::Point2D& point : pair.points_b) {
      point.x += 100;
    }
  }
  score = scoreSet(moved, sets[0], 1);
  CHECK(score.right == 0);
  CHECK(score.wrong == folder.pairs.size());
}
