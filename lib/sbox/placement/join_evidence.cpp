// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/join_evidence.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "sbox/core/logit.h"
#include "sbox/core/round.h"
#include "sbox/core/sort_descending.h"
#include "sbox/placement/settled_group.h"

namespace sbox {
namespace {

constexpr double kWorthALook = 0.05;   ///< Probability of a candidate.
constexpr size_t kMostProposals = 24;  ///< Poses that are weighed, the likeliest first.
/// Share of its weight that a pair keeps which sees nothing but what likelier ones see.
constexpr double kLeastWeight = 0.3;
/// Share of its weight that a missed pair has: maps that are hard to match are missed again and
/// again.
constexpr double kMissWeight = 0.5;

/// Probability that a pair is missed although the maps share this part of the smaller one.
double missProbability(double share) { return std::clamp(1.05 - 1.2 * share, 0.1, 1.0); }

const Footprint& footprint(const std::vector<Footprint>& maps, int map) {
  return maps[static_cast<size_t>(map)];
}

/// A candidate of a pair, as a pose of the groups.
struct Proposal {
  const CrossPair* from = nullptr;
  const EdgeCandidate* candidate = nullptr;
  Pose2D second_in_first;
};

/// Frame of the second group in the first, for a pose of the pair's b in its a.
Pose2D groupPose(const CrossPair& cross, const Pose2D& pose_b_in_a) {
  const Pose2D of_b = cross.pose_a_in_group + pose_b_in_a + inverse(cross.pose_b_in_group);
  return cross.turned ? inverse(of_b) : of_b;
}

/// The pose of the pair's b in its a, for a pose of the groups.
Pose2D pairPose(const CrossPair& cross, const Pose2D& second_in_first) {
  const Pose2D of_b = cross.turned ? inverse(second_in_first) : second_in_first;
  Pose2D pose = inverse(cross.pose_a_in_group) + of_b + cross.pose_b_in_group;
  pose.phi = wrapAngle(pose.phi);
  return pose;
}

std::vector<Proposal> proposalsOf(const std::vector<CrossPair>& pairs) {
  std::vector<Proposal> proposals;
  for (const CrossPair& cross : pairs) {
    for (const EdgeCandidate& candidate : cross.pair->candidates) {
      if (candidate.probability >= kWorthALook) {
        proposals.push_back({&cross, &candidate, groupPose(cross, candidate.pose_b_in_a)});
      }
    }
  }
  std::sort(proposals.begin(), proposals.end(), [](const Proposal& left, const Proposal& right) {
    return std::make_tuple(-left.candidate->probability, left.from->pair->a, left.from->pair->b) <
           std::make_tuple(-right.candidate->probability, right.from->pair->a, right.from->pair->b);
  });
  if (proposals.size() > kMostProposals) {
    proposals.resize(kMostProposals);
  }
  return proposals;
}

/// Coarse cells of the first group's frame that both maps of a pair know, ascending.
std::vector<std::pair<int, int>> commonCells(const CrossPair& cross, const Pose2D& pose_b_in_a,
                                             const std::vector<Footprint>& maps,
                                             const Pose2D& second_in_first) {
  constexpr double cell = 2;  // Metres; not less than that of most footprints.
  const Pose2D pose_a_in_first =
      cross.turned ? second_in_first + cross.pose_a_in_group : cross.pose_a_in_group;
  const double c = std::cos(pose_a_in_first.phi), s = std::sin(pose_a_in_first.phi);
  std::vector<std::pair<int, int>> cells;
  for (const Point2D& point :
       commonPoints(footprint(maps, cross.pair->a), footprint(maps, cross.pair->b), pose_b_in_a)) {
    cells.emplace_back(floorToInt((pose_a_in_first.x + point.x * c - point.y * s) / cell),
                       floorToInt((pose_a_in_first.y + point.x * s + point.y * c) / cell));
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// A pair that has a candidate where the pose of the groups puts it.
struct Witness {
  const CrossPair* cross = nullptr;
  Pose2D pose_b_in_a;
  int candidate = 0;
  double probability = 0;
  double missed = 0;  ///< What it would count if it had no such candidate, log odds.
};

/// The likeliest counts in full, the others as far as they speak of places that those before do
/// not: maps of one place are mistaken alike.
void hearWitnesses(std::vector<Witness>& witnesses, const std::vector<Footprint>& maps,
                   JoinEvidence& evidence) {
  std::sort(witnesses.begin(), witnesses.end(), [](const Witness& left, const Witness& right) {
    return std::make_tuple(-left.probability, left.cross->pair->a, left.cross->pair->b) <
           std::make_tuple(-right.probability, right.cross->pair->a, right.cross->pair->b);
  });
  std::vector<std::pair<int, int>> covered, before;  // Ascending.
  for (const Witness& witness : witnesses) {
    const PairEvidence& pair = *witness.cross->pair;
    const std::vector<std::pair<int, int>> cells =
        commonCells(*witness.cross, witness.pose_b_in_a, maps, evidence.second_in_first);
    before.swap(covered);
    covered.clear();
    std::set_union(before.begin(), before.end(), cells.begin(), cells.end(),
                   std::back_inserter(covered));
    const size_t fresh = covered.size() - before.size();
    // Of maps without a footprint nothing is known but that they are not the same two.
    const double fresh_share =
        cells.empty() ? 1 : static_cast<double>(fresh) / static_cast<double>(cells.size());
    const double log_odds = std::log(witness.probability / pair.none);
    if (&witness == &witnesses.front()) {
      evidence.strongest = witness.probability;
      evidence.accepted = pair.accepted == witness.candidate;
      evidence.log_odds += log_odds;
    } else {
      const double weight = kLeastWeight + (1 - kLeastWeight) * fresh_share;
      evidence.log_odds += std::max(weight * (log_odds + kLogCoincidence), witness.missed);
    }
    evidence.witnesses += fresh_share * trustOnAgreement(pair, witness.candidate);
  }
}

/// All pairs' word on one pose of the groups.
JoinEvidence weigh(const Pose2D& second_in_first, const std::vector<CrossPair>& pairs,
                   const std::vector<Footprint>& maps, const SamePoseOptions& same_pose) {
  JoinEvidence evidence;
  evidence.second_in_first = second_in_first;
  std::vector<Witness> witnesses;
  for (const CrossPair& cross : pairs) {
    const PairEvidence& pair = *cross.pair;
    const Footprint& a = footprint(maps, pair.a);
    const Footprint& b = footprint(maps, pair.b);
    const Pose2D pose_b_in_a = pairPose(cross, second_in_first);
    const double missed = kMissWeight * std::log(missProbability(overlapShare(a, b, pose_b_in_a)));
    const std::optional<int> number = chooseCandidate(pair, a, b, pose_b_in_a, same_pose);
    if (number) {
      witnesses.push_back({&cross, pose_b_in_a, *number,
                           pair.candidates[static_cast<size_t>(*number)].probability, missed});
    } else {
      evidence.log_odds += missed;
    }
  }
  hearWitnesses(witnesses, maps, evidence);
  return evidence;
}

}  // namespace

std::optional<JoinEvidence> weighJoin(const std::vector<CrossPair>& pairs,
                                      const std::vector<Footprint>& maps,
                                      const SamePoseOptions& same_pose) {
  std::vector<JoinEvidence> distinct;
  std::vector<JoinEvidence> weighed;
  std::vector<double> keys;
  const std::vector<Proposal> proposals = proposalsOf(pairs);
  for (const Proposal& proposal : proposals) {
    weighed.push_back(weigh(proposal.second_in_first, pairs, maps, same_pose));
    keys.push_back(weighed.back().log_odds);
  }
  for (const size_t i : descendingOrder(keys)) {
    const CrossPair& from = *proposals[i].from;
    const Footprint& a = footprint(maps, from.pair->a);
    const Footprint& b = footprint(maps, from.pair->b);
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const JoinEvidence& one) {
      const Pose2D pose_b_in_a = pairPose(from, one.second_in_first);
      return isSamePose(gapBetween(a, b, proposals[i].candidate->pose_b_in_a, pose_b_in_a), a, b,
                        same_pose);
    });
    if (!known) {
      distinct.push_back(weighed[i]);
    }
  }
  if (distinct.empty()) {
    return std::nullopt;
  }
  std::vector<double> log_odds;
  for (const JoinEvidence& evidence : distinct) {
    log_odds.push_back(evidence.log_odds);
  }
  distinct.front().probability = probabilitiesByLogit(log_odds, 0).front();
  return distinct.front();
}

}  // namespace sbox
