// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/report/summary.h"

using namespace sbox;
using Lines = std::vector<std::string>;

namespace {

MergeResult results(const std::vector<std::string>& names) {
  MergeResult result;
  for (const std::string& name : names) {
    MapOutcome map;
    map.name = name;
    map.placement.group = static_cast<int>(result.maps.size());
    result.maps.push_back(map);
  }
  return result;
}

MapPair pairOf(int a, int b, Verdict verdict, double confidence) {
  MapPair pair{a, b, {}};
  pair.result.verdict = verdict;
  pair.result.reason = "as seen";
  pair.result.has_pose = true;
  pair.result.pose_b_in_a = {1.2341, -0.5671, 12.34 * M_PI / 180};
  pair.result.confidence = confidence;
  return pair;
}

}  // namespace

TEST_CASE("two merged maps take one line") {
  MergeResult result = results({"a.gridmap", "b.gridmap"});
  result.pairs = {pairOf(0, 1, Verdict::Accepted, 0.98)};
  result.maps[1].placement.pose = result.pairs[0].result.pose_b_in_a;
  result.merged.resize(1);
  result.merged[0].members = {0, 1};
  CHECK(summaryLines(result, {"merged.gridmap"}) ==
        Lines{"merged.gridmap: 2 of 2 maps merged, b.gridmap in a.gridmap: x 1.234 m, y -0.567 m, "
              "phi 12.34 deg (confidence 0.98)"});
}

TEST_CASE("merged maps that were not written have no file name") {
  MergeResult two = results({"a.gridmap", "b.gridmap"});
  two.pairs = {pairOf(0, 1, Verdict::Accepted, 0.98)};
  two.merged.resize(1);
  two.merged[0].members = {0, 1};
  CHECK(summaryLines(two, {}) ==
        Lines{"2 of 2 maps merged, b.gridmap in a.gridmap: x 0.000 m, y 0.000 m, phi 0.00 deg "
              "(confidence 0.98)"});

  MergeResult four = results({"a", "b", "c", "d"});
  four.merged.resize(2);
  four.merged[0].members = {0, 1};
  four.merged[1].members = {2, 3};
  four.merged[1].reference = 2;
  CHECK(summaryLines(four, {"one.gridmap"}) ==
        Lines{"one.gridmap: 2 of 4 maps merged in a", "b in a: x 0.000 m, y 0.000 m, phi 0.00 deg",
              "2 of 4 maps merged in c", "d in c: x 0.000 m, y 0.000 m, phi 0.00 deg"});
}

TEST_CASE("two refused maps take one line with the best candidate") {
  MergeResult result = results({"a.gridmap", "b.gridmap"});
  result.pairs = {pairOf(0, 1, Verdict::Ambiguous, 0.4)};
  CHECK(summaryLines(result, {}) ==
        Lines{"0 of 2 maps merged, b.gridmap in a.gridmap: ambiguous, as seen (best candidate x "
              "1.234 m, y -0.567 m, phi 12.34 deg, confidence 0.40)"});
}

TEST_CASE("an accepted pair that was not merged says why") {
  MergeResult result = results({"a", "b"});
  result.pairs = {pairOf(0, 1, Verdict::Accepted, 0.8)};
  const std::string line = summaryLines(result, {}).at(0);
  CHECK(line.find("; not taken: --initial speaks against it") != std::string::npos);
}

TEST_CASE("maps that lie elsewhere than they were said to are warned of") {
  MergeResult result = results({"a", "b"});
  CHECK(warningLines(result).empty());
  result.overruled = {{1, 0, 74.26, 1.36}};
  CHECK(warningLines(result) ==
        Lines{"b lies 74.3 m and 78 deg from where it was said to, beside a"});
}

TEST_CASE("of more maps each has its line") {
  MergeResult result = results({"a", "b", "c"});
  result.pairs = {pairOf(0, 1, Verdict::Accepted, 0.9), pairOf(0, 2, Verdict::Rejected, 0.1),
                  pairOf(1, 2, Verdict::Rejected, 0.2)};
  result.maps[1].placement.group = 0;
  result.maps[1].placement.pose = {2, 3, 0};
  result.merged.resize(1);
  result.merged[0].members = {0, 1};
  CHECK(summaryLines(result, {"m.yaml"}) ==
        Lines{"m.yaml: 2 of 3 maps merged in a", "b in a: x 2.000 m, y 3.000 m, phi 0.00 deg",
              "c: left out; c in b: rejected, as seen (best candidate x 1.234 m, y -0.567 m, phi "
              "12.34 deg, confidence 0.20)"});
}

TEST_CASE("groups that are not merged are told, and what the maps say together of a pair") {
  MergeResult result = results({"a", "b", "c", "d", "e"});
  result.pairs = {pairOf(0, 1, Verdict::Accepted, 0.9), pairOf(0, 4, Verdict::Accepted, 0.8),
                  pairOf(2, 3, Verdict::Ambiguous, 0.4)};
  result.pairs[2].settlement = PairSettlement{true, 2, 0.25, 0.1};
  result.maps[1].placement.group = 0;
  result.maps[3].placement.group = 2;
  result.merged.resize(1);
  result.merged[0].members = {0, 1};
  const Lines lines = summaryLines(result, {"m.yaml"});
  REQUIRE(lines.size() == 4);
  CHECK(lines[2] == "c, d: left out, a group of their own");
  CHECK(lines[3] ==
        "e: left out; e in a: accepted, as seen (best candidate x 1.234 m, y -0.567 m, phi 12.34 "
        "deg, confidence 0.80); not taken: no other pair bears it out");
  CHECK(detailLines(result)[7] ==
        "d in c: ambiguous, as seen (best candidate x 1.234 m, y -0.567 m, phi 12.34 deg, "
        "confidence 0.40); by all maps alternative 2 is right within 0.25 m, 5.7 deg");
}
