// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "catch.h"
#include "sbox/adjustment/overlapping_frames.h"

using namespace sbox;

namespace {

std::vector<std::pair<int, int>> numbers(const std::vector<FramePair>& pairs) {
  std::vector<std::pair<int, int>> all;
  for (const FramePair& pair : pairs) {
    all.emplace_back(pair.a, pair.b);
  }
  return all;
}

}  // namespace

TEST_CASE("of each passage the nearest key frame is a partner", "[adjustment]") {
  OverlapOptions options;
  options.radius = 1.2;
  options.passage = 3;
  // Out and, from key frame 5 on, back beside it.
  const std::vector<Pose2D> poses{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}};
  using Numbers = std::vector<std::pair<int, int>>;
  CHECK(numbers(overlappingFrames(poses, {0, 0, 0, 0, 0, 0}, options)) == Numbers{{0, 5}});
  // The way back by another robot.
  CHECK(numbers(overlappingFrames(poses, {0, 0, 0, 1, 1, 1}, options)) ==
        Numbers{{0, 5}, {1, 4}, {2, 3}});
  options.radius = 0.9;
  CHECK(overlappingFrames(poses, {0, 0, 0, 1, 1, 1}, options).empty());
}

TEST_CASE("a key frame that looks the same way is nearer", "[adjustment]") {
  OverlapOptions options;
  options.partners = 1;
  const std::vector<Pose2D> poses{{0, 0, 0}, {0.6, 0, 3}, {1, 0, 0}};
  const std::vector<FramePair> pairs = overlappingFrames(poses, {0, 1, 2}, options);
  CHECK(numbers(pairs) == std::vector<std::pair<int, int>>{{0, 2}, {1, 2}});
}

TEST_CASE("partners are few, near, and of passages of their own", "[adjustment]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 6), heading(-M_PI, M_PI);
  std::vector<Pose2D> poses;
  std::vector<int> map_of;
  for (int i = 0; i < 150; ++i) {
    poses.emplace_back(place(random), place(random), heading(random));
    map_of.push_back(i / 50);
  }
  const OverlapOptions options;
  const auto pairs = numbers(overlappingFrames(poses, map_of, options));
  CHECK(pairs.size() > 150);
  CHECK(pairs.size() <= 150 * static_cast<size_t>(options.partners));
  CHECK(std::is_sorted(pairs.begin(), pairs.end()));
  CHECK(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
  for (const auto& [a, b] : pairs) {
    const auto i = static_cast<size_t>(a), j = static_cast<size_t>(b);
    CHECK(a < b);
    CHECK(std::hypot(poses[i].x - poses[j].x, poses[i].y - poses[j].y) <= options.radius);
    CHECK((map_of[i] != map_of[j] || b - a > options.passage));
  }
}
