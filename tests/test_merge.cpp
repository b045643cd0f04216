// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "catch.h"
#include "drawing.h"
#include "sbox/merge.h"

using namespace sbox;

namespace {

bool same(const Pose2D& left, const Pose2D& right) {
  return left.x == right.x && left.y == right.y && left.phi == right.phi;
}

void checkSame(const PairResult& left, const PairResult& right) {
  CHECK(left.verdict == right.verdict);
  CHECK(left.reason == right.reason);
  CHECK(left.has_pose == right.has_pose);
  CHECK(same(left.pose_b_in_a, right.pose_b_in_a));
  CHECK(left.covariance == right.covariance);
  CHECK(left.confidence == right.confidence);
  CHECK(left.overlap_m2 == right.overlap_m2);
  CHECK(left.matched_boxes == right.matched_boxes);
  CHECK(left.alternatives.size() == right.alternatives.size());
}

}  // namespace

TEST_CASE("the number of threads changes neither pairs nor poses nor any cell", "[merge]") {
  const test::Floor floor = test::officeFloor();
  const std::vector<Map> maps{
      test::exploreMap(floor, {2, 1, 0}, 0.1, {{-1, -1}, {16, 15}}),
      test::exploreMap(floor, {15, -6, -0.9}, 0.1, {{5, -1}, {25, 15}}),
      test::exploreMap(floor, {0, 0, 2.2}, 0.1, {{-1, 4}, {25, 15}}),
      test::exploreMap(test::randomFloor(3), {}, 0.1),
  };
  MergeOptions options;
  options.threads = 1;
  const MergeResult one = mergeMaps(maps, options);
  REQUIRE(one.pairs.size() == 6);
  REQUIRE(one.merged.size() == 1);
  for (const int threads : {2, 4}) {
    INFO("threads " << threads);
    options.threads = threads;
    const MergeResult more = mergeMaps(maps, options);
    REQUIRE(more.pairs.size() == one.pairs.size());
    for (size_t i = 0; i < one.pairs.size(); ++i) {
      checkSame(one.pairs[i].result, more.pairs[i].result);
    }
    REQUIRE(more.merged.size() == 1);
    const Map &left = one.merged[0].map, &right = more.merged[0].map;
    CHECK(same(left.corner_in_map, right.corner_in_map));
    REQUIRE(left.width() == right.width());
    REQUIRE(left.height() == right.height());
    CHECK(left.grid.getRawMap() == right.grid.getRawMap());
  }
}
