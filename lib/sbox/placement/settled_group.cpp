// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/settled_group.h"

#include <cmath>
#include <limits>
#include <utility>

namespace sbox {
namespace {

constexpr int kMostRounds = 10;

/// The pose of member b in member a.
Pose2D relativePose(const std::vector<Pose2D>& poses, int a, int b) {
  Pose2D pose = inverse(poses[static_cast<size_t>(a)]) + poses[static_cast<size_t>(b)];
  pose.phi = wrapAngle(pose.phi);
  return pose;
}

std::vector<ChosenEdge> chooseEdges(const std::vector<int>& members,
                                    const std::vector<Pose2D>& poses,
                                    const std::vector<PairEvidence>& pairs,
                                    const std::vector<Footprint>& maps,
                                    const SamePoseOptions& same_pose) {
  std::vector<int> node_of(maps.size(), -1);
  for (size_t i = 0; i < members.size(); ++i) {
    node_of[static_cast<size_t>(members[i])] = static_cast<int>(i);
  }
  std::vector<ChosenEdge> chosen;
  for (size_t i = 0; i < pairs.size(); ++i) {
    const PairEvidence& pair = pairs[i];
    const int a = node_of[static_cast<size_t>(pair.a)], b = node_of[static_cast<size_t>(pair.b)];
    if (a < 0 || b < 0) {
      continue;
    }
    const std::optional<int> number =
        chooseCandidate(pair, maps[static_cast<size_t>(pair.a)], maps[static_cast<size_t>(pair.b)],
                        relativePose(poses, a, b), same_pose);
    if (number) {
      const EdgeCandidate& candidate = pair.candidates[static_cast<size_t>(*number)];
      chosen.push_back(
          {static_cast<int>(i),
           *number,
           {a, b, candidate.pose_b_in_a, candidate.covariance / trustOnAgreement(pair, *number)}});
    }
  }
  return chosen;
}

bool sameChoice(const std::vector<ChosenEdge>& left, const std::vector<ChosenEdge>& right) {
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const ChosenEdge& one, const ChosenEdge& other) {
                      return one.pair == other.pair && one.candidate == other.candidate;
                    });
}

}  // namespace

bool SettledGroup::isConnected() const {
  return connectedParts(members.size(), graphEdges()).size() <= 1;
}

std::vector<GraphEdge> SettledGroup::graphEdges() const {
  std::vector<GraphEdge> all;
  all.reserve(edges.size());
  for (const ChosenEdge& chosen : edges) {
    all.push_back(chosen.edge);
  }
  return all;
}

std::optional<int> chooseCandidate(const PairEvidence& pair, const Footprint& a, const Footprint& b,
                                   const Pose2D& pose_b_in_a, const SamePoseOptions& options) {
  std::optional<int> best;
  double best_cost = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < pair.candidates.size(); ++i) {
    const EdgeCandidate& candidate = pair.candidates[i];
    if (!isSamePose(gapBetween(a, b, candidate.pose_b_in_a, pose_b_in_a), a, b, options)) {
      continue;
    }
    // Twice the negative log likelihood, with the tails of a Student distribution.
    constexpr double freedom = 4;
    const double squared =
        squaredResidual({0, 1, candidate.pose_b_in_a, candidate.covariance}, {}, pose_b_in_a);
    const double cost =
        freedom * std::log1p(squared / freedom) - 2 * std::log(candidate.probability);
    if (cost < best_cost) {
      best_cost = cost;
      best = static_cast<int>(i);
    }
  }
  return best;
}

SettledGroup settleGroup(std::vector<int> members, std::vector<Pose2D> poses,
                         const std::vector<PairEvidence>& pairs, const std::vector<Footprint>& maps,
                         const SamePoseOptions& same_pose, const PoseGraphOptions& graph) {
  SettledGroup group;
  group.members = std::move(members);
  group.poses = std::move(poses);
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<ChosenEdge> chosen =
        chooseEdges(group.members, group.poses, pairs, maps, same_pose);
    if (round > 0 && sameChoice(chosen, group.edges)) {
      break;
    }
    group.edges = std::move(chosen);
    if (!group.isConnected()) {
      break;
    }
    group.solution = solvePoseGraph(group.poses, 0, group.graphEdges(), graph);
    group.poses = group.solution.poses;
  }
  return group;
}

}  // namespace sbox
