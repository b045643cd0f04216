// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/paper/rough_match.h"

using namespace sbox;

namespace {

SuppositionalBox box(double width, double height) {
  return describeBox({{{0, 0}, {width, 0}, {width, height}, {0, height}}});
}

}  // namespace

TEST_CASE("boxes match by both sides, lying or standing", "[paper]") {
  RoughMatchOptions options;
  options.side_tolerance = 0.5;
  const auto matches = findRoughMatches({box(3, 5), box(2, 2)},
                                        {box(5.4, 3.4), box(3, 5.6), box(2.2, 1.9)}, options);
  REQUIRE(matches.size() == 2);
  CHECK(matches[0].a == 0);
  CHECK(matches[0].b == 0);
  CHECK(matches[1].a == 1);
  CHECK(matches[1].b == 2);
}

TEST_CASE("no more matches than asked for", "[paper]") {
  RoughMatchOptions options;
  options.max_matches = 3;
  const std::vector<SuppositionalBox> equal(4, box(3, 5));
  const auto matches = findRoughMatches(equal, equal, options);
  REQUIRE(matches.size() == 3);
  CHECK(matches[2].a == 0);
  CHECK(matches[2].b == 2);
}
