// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A made-up result for pages: two rooms that fit in one place, and two that fit in several.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/map.h"
#include "sbox/merge_result.h"

namespace sbox::test {

/// A room of width x height cells of 0.1 m with walls all round.
inline Map roomMap(const std::string& name, int width, int height) {
  Map map = makeMap(name, width, height, 0.1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool wall = x == 0 || y == 0 || x == width - 1 || y == height - 1;
      map.grid.setCell(x, y, wall ? 0.05F : 0.95F);
    }
  }
  return map;
}

struct HtmlCase {
  std::vector<Map> maps;
  MergeResult result;
};

/// Map 1 lies in map 0 by a quarter turn, accepted; map 2 fits map 0 in three places, ambiguous;
/// maps 1 and 2 were rejected without any candidate.
inline HtmlCase htmlCase(const std::string& name = "maps/first.yaml") {
  HtmlCase made;
  made.maps = {roomMap(name, 60, 40), roomMap("maps/second.yaml", 40, 60),
               roomMap("maps/third.gridmap", 20, 20)};
  MergeResult& result = made.result;
  result.status = MergeStatus::Partly;
  for (const Map& map : made.maps) {
    MapOutcome outcome;
    outcome.name = map.name;
    outcome.width = map.width();
    outcome.height = map.height();
    outcome.resolution = map.resolution();
    outcome.features.lines = {{{0, 0}, {1, 0}}};
    outcome.features.vertical_points = {{0, 0}, {1, 1}};
    outcome.features.boxes = {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
    result.maps.push_back(outcome);
  }
  const Pose2D quarter{6, 0, M_PI / 2};
  result.maps[0].placed = result.maps[1].placed = true;
  result.maps[1].placement.pose = quarter;
  result.maps[1].placement.covariance = PoseCovariance::Identity() * 0.0004;
  result.maps[2].placement.group = 1;

  result.pairs = {{0, 1, {}}, {0, 2, {}}, {1, 2, {}}};
  PairResult& accepted = result.pairs[0].result;
  accepted.verdict = Verdict::Accepted;
  accepted.reason = "the walls agree";
  accepted.has_pose = true;
  accepted.pose_b_in_a = quarter;
  accepted.covariance = PoseCovariance::Identity() * 0.0004;
  accepted.confidence = 0.97;
  accepted.kalman = Pose2D{6.03, 0.04, M_PI / 2};
  PairResult& ambiguous = result.pairs[1].result;
  ambiguous.verdict = Verdict::Ambiguous;
  ambiguous.reason = "three corners of the room look alike";
  ambiguous.has_pose = true;
  ambiguous.pose_b_in_a = {2, 1, 0};
  ambiguous.confidence = 0.4;
  ambiguous.alternatives = {{{0, 0, 0}, 0.3}, {{4, 2, 0}, 0.2}};
  result.pairs[2].result.reason = "nothing in common";

  MergedGroup merged;
  merged.members = {0, 1};
  merged.map = made.maps[0];
  merged.conflict_share = 0.012;
  result.merged.push_back(merged);
  return made;
}

}  // namespace sbox::test
