// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/adjustment/overlapping_frames.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace sbox {
namespace {

/// Frames of one map that follow each other within a passage.
bool onePassage(int i, int j, const std::vector<int>& map_of, int passage) {
  return std::abs(i - j) <= passage &&
         map_of[static_cast<size_t>(i)] == map_of[static_cast<size_t>(j)];
}

/// The frames near frame i that are of other passages, the nearest first.
std::vector<std::pair<double, int>> near(int i, const std::vector<Pose2D>& poses,
                                         const std::vector<int>& map_of,
                                         const OverlapOptions& options) {
  std::vector<std::pair<double, int>> found;
  const Pose2D& from = poses[static_cast<size_t>(i)];
  for (int j = 0; j < static_cast<int>(poses.size()); ++j) {
    const Pose2D& to = poses[static_cast<size_t>(j)];
    const double distance = std::hypot(to.x - from.x, to.y - from.y);
    if (distance <= options.radius && !onePassage(i, j, map_of, options.passage)) {
      found.emplace_back(distance + options.turn_cost * std::abs(wrapAngle(to.phi - from.phi)), j);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::vector<FramePair> overlappingFrames(const std::vector<Pose2D>& poses,
                                         const std::vector<int>& map_of,
                                         const OverlapOptions& options) {
  std::set<std::pair<int, int>> pairs;
  for (int i = 0; i < static_cast<int>(poses.size()); ++i) {
    std::vector<int> chosen;
    for (const auto& candidate : near(i, poses, map_of, options)) {
      const int j = candidate.second;
      if (static_cast<int>(chosen.size()) == options.partners) {
        break;
      }
      if (std::none_of(chosen.begin(), chosen.end(),
                       [&](int other) { return onePassage(j, other, map_of, options.passage); })) {
        chosen.push_back(j);
        pairs.emplace(std::min(i, j), std::max(i, j));
      }
    }
  }
  std::vector<FramePair> sorted;
  sorted.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    sorted.push_back({a, b});
  }
  return sorted;
}

}  // namespace sbox
