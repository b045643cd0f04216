// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/best_pair.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "sbox/paper/candidate_transforms.h"

namespace sbox {
namespace {

/// Among candidates the score decides, before them the number of agreeing matches.
bool isBetter(const BestPair& p, const BestPair& q) {
  const auto rank = [](const BestPair& pair) {
    return std::make_tuple(pair.enough, pair.enough ? size_t{0} : pair.agreement.matches.size(),
                           pair.score);
  };
  return rank(p) > rank(q);
}

}  // namespace

double score(const SuppositionalBox& box_a, const SuppositionalBox& box_b,
             const Agreement& agreement, double least_distance) {
  return std::min(box_a.area, box_b.area) / std::max(agreement.distance_sum, least_distance);
}

std::optional<BestPair> findBestPair(const std::vector<SuppositionalBox>& boxes_a,
                                     const std::vector<SuppositionalBox>& boxes_b,
                                     const BestPairOptions& options) {
  const AgreementIndex index(boxes_a, boxes_b, options.rough_match.side_tolerance,
                             options.agreement);
  std::optional<BestPair> best;
  for (const RoughMatch& match : findRoughMatches(boxes_a, boxes_b, options.rough_match)) {
    const SuppositionalBox& box_a = boxes_a[static_cast<size_t>(match.a)];
    const SuppositionalBox& box_b = boxes_b[static_cast<size_t>(match.b)];
    const std::array<Pose2D, 4> transforms = candidateTransforms(box_a, box_b);
    for (size_t shift = 0; shift < 4; ++shift) {
      const Pose2D& pose_a_in_b = transforms[shift];
      // A shift that lays the long side on the short one does not even fit its own boxes.
      if (largestCornerDistance(box_a, box_b, pose_a_in_b) >= options.agreement.corner_distance) {
        continue;
      }
      BestPair pair;
      pair.match = match;
      pair.shift = static_cast<int>(shift);
      pair.pose_a_in_b = pose_a_in_b;
      pair.agreement = index.find(pose_a_in_b, match);
      pair.score = score(box_a, box_b, pair.agreement, options.least_distance);
      pair.enough = pair.agreement.matches.size() >= static_cast<size_t>(options.min_agreeing);
      if (!best || isBetter(pair, *best)) {
        best = std::move(pair);
      }
    }
  }
  return best;
}

}  // namespace sbox
