// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "catch.h"
#include "drawing.h"
#include "sbox/match_share.h"
#include "sbox/merge.h"
#include "sbox/report/report_json.h"

using namespace sbox;

namespace {

std::vector<Map> fourMaps() {
  const test::Floor floor = test::officeFloor();
  return {test::exploreMap(floor, {2, 1, 0}, 0.1, {{-1, -1}, {16, 15}}),
          test::exploreMap(floor, {15, -6, -0.9}, 0.1, {{5, -1}, {25, 15}}),
          test::exploreMap(floor, {0, 0, 2.2}, 0.1, {{-1, 4}, {25, 15}}),
          test::exploreMap(test::randomFloor(3), {}, 0.1)};
}

std::string reportOf(MergeResult result) {
  result.seconds = {};
  return reportJson(result, {"merged.gridmap"});
}

std::vector<MatchedShare> allShares(const std::vector<Map>& maps, const MergeOptions& options,
                                    int count) {
  std::vector<MatchedShare> shares;
  for (int number = count; number >= 1; --number) {
    shares.push_back(matchShare(maps, options, {number, count}));
  }
  return shares;
}

/// "INDEX REASON" of the refusal; empty if the shares are joined.
std::string refusal(const std::vector<Map>& maps, const MergeOptions& options,
                    const std::vector<MatchedShare>& shares) {
  try {
    (void)joinShares(maps, options, shares);
  } catch (const ShareError& error) {
    return std::to_string(error.index()) + " " + error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("shares joined give what one machine gives, whether all pairs are matched or few",
          "[match_share]") {
  const std::vector<Map> maps = fourMaps();
  for (const int partners : {0, 1, 2}) {
    MergeOptions options;
    options.retrieval.partners = partners;
    const MergeResult alone = mergeMaps(maps, options);
    REQUIRE(alone.merged.size() == 1);
    for (const int count : {1, 2, 3, 7}) {
      INFO("partners " << partners << ", shares " << count);
      const std::vector<MatchedShare> shares = allShares(maps, options, count);
      MatchStore known = joinShares(maps, options, shares);
      int matched_anew = 0;
      const MergeResult joined =
          mergeMaps(maps, options, known, [&](const std::string& stage, int, int total) {
            matched_anew = stage == "pairs" ? total : matched_anew;
          });
      CHECK(reportOf(joined) == reportOf(alone));
      CHECK(matched_anew == 0);
    }
  }
}

TEST_CASE("no pair is in two shares where all pairs are matched", "[match_share]") {
  const std::vector<Map> maps = fourMaps();
  size_t pairs = 0;
  for (const MatchedShare& share : allShares(maps, {}, 4)) {
    CHECK(share.pairs.size() >= 1);
    pairs += share.pairs.size();
  }
  CHECK(pairs == 6);
}

TEST_CASE("shares of other maps, other options or other numbers are refused by name",
          "[match_share]") {
  const std::vector<Map> maps = fourMaps();
  const std::vector<MatchedShare> shares = allShares(maps, {}, 3);
  CHECK(refusal(maps, {}, shares).empty());
  CHECK(refusal(maps, {}, {shares[0], shares[2]}) == "0 is of 3 shares, but share 2 is missing");
  CHECK(refusal(maps, {}, {shares[0], shares[1], shares[1]}) ==
        "2 holds share 2/3, which another file holds, too");
  CHECK(refusal(maps, {}, {shares[0], matchShare(maps, {}, {1, 2})}) ==
        "1 holds share 1/2, but others are of 3");
  const MatchedShare whole = matchShare(maps, {}, {1, 1});
  for (const int number : {0, -1, 2}) {
    std::vector<MatchedShare> numbered{whole, whole};
    numbered[1].share.number = number;
    CHECK(refusal(maps, {}, numbered) ==
          "1 holds share " + std::to_string(number) + "/1, which there is not");
  }
  MergeOptions other;
  other.pair.votes.bin = 0.7;
  CHECK(refusal(maps, other, shares) ==
        "2 was made with other options, or by another version of sbox-merge");
  MergeOptions fusion_only;
  fusion_only.fusion.rule = FusionRule::Table;
  CHECK(refusal(maps, fusion_only, shares).empty());
  std::vector<Map> exchanged = maps;
  std::swap(exchanged[0], exchanged[1]);
  CHECK(refusal(exchanged, {}, shares) == "2 was made of other maps, or of these in another order");
  std::vector<Map> changed = maps;
  changed[3].grid.setCell(0, 0, 0.123F);
  CHECK(refusal(changed, {}, shares) == "2 was made of other maps, or of these in another order");
}

TEST_CASE("a share that names what does not exist is refused", "[match_share]") {
  const std::vector<Map> maps = fourMaps();
  const std::vector<MatchedShare> shares{matchShare(maps, {}, {1, 1})};
  const auto refused = [&](const auto& spoil) {
    std::vector<MatchedShare> spoilt = shares;
    spoil(spoilt[0].pairs[0]);
    return refusal(maps, {}, spoilt) == "0 holds a pair of maps or boxes that do not exist";
  };
  CHECK_FALSE(refused([](MapPair&) {}));
  CHECK(refused([](MapPair& pair) { pair.b = 4; }));
  CHECK(refused([](MapPair& pair) { pair.a = pair.b; }));
  CHECK(refused([](MapPair& pair) { pair.result.matched_boxes.emplace_back(0, 1 << 20); }));
}
