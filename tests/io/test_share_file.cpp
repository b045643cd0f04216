// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox/io/file_error.h"
#include "sbox/io/share_file.h"

using namespace sbox;

namespace {

MatchedShare someShare() {
  MatchedShare share;
  share.share = {2, 5};
  share.options_digest = 0x0123456789abcdefULL;
  share.map_digests = {1, ~0ULL, 42};
  MapPair found{0, 2, {}};
  PairResult& result = found.result;
  result.verdict = Verdict::Ambiguous;
  result.reason = "two answers, \"a\" and \"b\"";
  result.has_pose = true;
  result.pose_b_in_a = {1.0 / 3, -1e-17, 3.0000000000000004};
  result.covariance << 0.1, 0.2, 0.3, 0.2, 0.5, 0.6, 0.3, 0.6, 1e-9;
  result.confidence = 0.1 + 0.2;
  result.overlap_m2 = 12.5;
  result.kalman = Pose2D(1, 2, 3);
  result.matched_boxes = {{0, 7}, {3, 1}};
  result.alternatives = {{{4, 5, 6}, 0.25}};
  share.pairs = {found, {1, 2, {}}};
  share.pairs[1].result.reason = "nothing in common";
  return share;
}

bool isRefused(const std::string& text) {
  const ScratchFolder folder;
  try {
    (void)loadShare(folder.write("share.json", text));
  } catch (const FileError& error) {
    CHECK(error.reason() == "is not what --pairs writes, or is damaged: make it anew");
    return true;
  }
  return false;
}

/// The share's text with one piece of it changed.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = shareJson(someShare(), {"a", "b", "c"});
  const size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("a share is read back to the last bit", "[share_file]") {
  const ScratchFolder folder;
  const MatchedShare share = someShare();
  const std::string text = shareJson(share, {"a", "b", "c"});
  const MatchedShare read = loadShare(folder.write("share.json", text));
  CHECK(read.share.number == 2);
  CHECK(read.share.count == 5);
  CHECK(read.options_digest == share.options_digest);
  CHECK(read.map_digests == share.map_digests);
  REQUIRE(read.pairs.size() == 2);
  const PairResult &expected = share.pairs[0].result, &result = read.pairs[0].result;
  CHECK(read.pairs[0].b == 2);
  CHECK(result.verdict == expected.verdict);
  CHECK(result.reason == expected.reason);
  CHECK(result.pose_b_in_a.x == expected.pose_b_in_a.x);
  CHECK(result.pose_b_in_a.y == expected.pose_b_in_a.y);
  CHECK(result.pose_b_in_a.phi == expected.pose_b_in_a.phi);
  CHECK(result.covariance == expected.covariance);
  CHECK(result.confidence == expected.confidence);
  CHECK(result.overlap_m2 == expected.overlap_m2);
  CHECK(result.kalman->y == 2);
  CHECK_FALSE(result.ceres);
  CHECK(result.matched_boxes == expected.matched_boxes);
  REQUIRE(result.alternatives.size() == 1);
  CHECK(result.alternatives[0].confidence == 0.25);
  CHECK_FALSE(read.pairs[1].result.has_pose);
  CHECK(read.pairs[1].result.covariance == PairResult().covariance);
  CHECK(shareJson(read, {"a", "b", "c"}) == text);
}

TEST_CASE("what --pairs did not write is refused in one line", "[share_file]") {
  CHECK_FALSE(isRefused(changed("ambiguous", "rejected")));
  CHECK(isRefused("{}"));
  CHECK(isRefused("[1, 2"));
  CHECK(isRefused(std::string(100000, '[')));
  CHECK(isRefused(changed("sbox-merge pairs", "sbox-merge report")));
  CHECK(isRefused(changed("\"version\":2", "\"version\":1")));
  CHECK(isRefused(changed("\"share\":2", "\"share\":6")));
  CHECK(isRefused(changed("\"share\":2", "\"share\":0")));
  CHECK(isRefused(changed("\"of\":5", "\"of\":5e99")));
  CHECK(isRefused(changed("\"a\":0", "\"a\":-1")));
  CHECK(isRefused(changed("\"a\":0", "\"a\":0.5")));
  CHECK(isRefused(changed("ambiguous", "sure")));
  CHECK(isRefused(changed("12.5", "1e999")));
  CHECK(isRefused(changed("\"a\":0", "\"a\":18446744073709551615")));
  CHECK(isRefused(changed("\"x\":4.0", "\"x\":1e300")));
  CHECK(isRefused(changed("\"phi\":6.0", "\"phi\":1e6")));
  CHECK(isRefused(changed("12.5", "null")));
  CHECK(isRefused(changed("12.5", "true")));
  CHECK(isRefused(changed("0.25", "1.25")));
  CHECK(isRefused(changed(",\"phi\":6.0", "")));
  CHECK(isRefused(changed("[0.3,0.6,1e-09]", "[0.3,0.6]")));
  CHECK(isRefused(changed("[[0.1,0.2,0.3],[0.2,0.5,0.6],[0.3,0.6,1e-09]]", "null")));
  CHECK(isRefused(changed("[0,7],[3,1]", "[0,7]")));
  CHECK(isRefused(changed("[0,7]", "[0,7,1]")));
  CHECK(isRefused(changed("0123456789abcdef", "0123456789abcdeg")));
  CHECK_THROWS_AS(loadShare("missing.json"), FileError);
}
