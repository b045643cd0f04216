// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/place_maps.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "sbox/placement/pair_evidence.h"
#include "sbox/placement/settled_group.h"

namespace sbox {
namespace {

/// The pairs by number, ordered by their maps.
std::vector<size_t> orderedPairs(size_t map_count, const std::vector<MapPair>& pairs) {
  const auto count = static_cast<int>(map_count);
  for (const MapPair& pair : pairs) {
    if (pair.a < 0 || pair.b < 0 || pair.a >= count || pair.b >= count || pair.a == pair.b) {
      throw std::invalid_argument("a pair names a map that does not exist");
    }
  }
  std::vector<size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t left, size_t right) {
    return std::make_tuple(pairs[left].a, pairs[left].b) <
           std::make_tuple(pairs[right].a, pairs[right].b);
  });
  return order;
}

/// What the poses say of a pair of which no candidate agrees.
PairSettlement nearest(const PairEvidence& pair, const std::vector<Footprint>& maps,
                       const Pose2D& pose_b_in_a) {
  PairSettlement settlement;
  settlement.distance = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < pair.candidates.size(); ++i) {
    const PoseGap gap =
        gapBetween(maps[static_cast<size_t>(pair.a)], maps[static_cast<size_t>(pair.b)],
                   pair.candidates[i].pose_b_in_a, pose_b_in_a);
    if (gap.distance < settlement.distance) {
      settlement.candidate = static_cast<int>(i);
      settlement.distance = gap.distance;
      settlement.turn = gap.turn;
    }
  }
  return settlement;
}

/// Poses and covariances of the members in the frame of their reference.
void placeMembers(const SettledGroup& settled, const MapGroup& group, int number,
                  std::vector<MapPlacement>& maps) {
  const auto found = std::find(settled.members.begin(), settled.members.end(), group.reference);
  const auto reference = static_cast<int>(found - settled.members.begin());
  const Pose2D group_in_reference = inverse(settled.poses[static_cast<size_t>(reference)]);
  PoseGraphSolution solution = settled.solution;
  solution.poses.clear();
  for (size_t i = 0; i < settled.poses.size(); ++i) {
    Pose2D pose =
        static_cast<int>(i) == reference ? Pose2D() : group_in_reference + settled.poses[i];
    pose.phi = wrapAngle(pose.phi);
    solution.poses.push_back(pose);
  }
  const std::vector<PoseCovariance> covariances =
      poseCovariances(solution, reference, settled.graphEdges());
  for (size_t i = 0; i < settled.members.size(); ++i) {
    maps[static_cast<size_t>(settled.members[i])] = {number, solution.poses[i], covariances[i],
                                                     group.reference};
  }
}

/// The members that lie elsewhere than their guesses say, beside the one with whose guess most
/// others agree.
std::vector<OverruledGuess> overruledIn(const MapGroup& group,
                                        const std::vector<const InitialGuess*>& guess_of,
                                        const std::vector<Footprint>& shapes,
                                        const std::vector<MapPlacement>& placed) {
  std::vector<const InitialGuess*> guesses;
  for (const int member : group.members) {
    if (const InitialGuess* guess = guess_of[static_cast<size_t>(member)]) {
      guesses.push_back(guess);
    }
  }
  std::vector<OverruledGuess> fewest;
  for (const InitialGuess* beside : guesses) {
    const auto a = static_cast<size_t>(beside->map);
    std::vector<OverruledGuess> overruled;
    for (const InitialGuess* guess : guesses) {
      const auto b = static_cast<size_t>(guess->map);
      const Pose2D pose_b_in_a = inverse(placed[a].pose) + placed[b].pose;
      if (const auto found = overruledGuess(*beside, *guess, shapes[a], shapes[b], pose_b_in_a)) {
        overruled.push_back(*found);
      }
    }
    if (beside == guesses.front() || overruled.size() < fewest.size()) {
      fewest = std::move(overruled);
    }
  }
  return fewest;
}

}  // namespace

PlacementResult placeMaps(const std::vector<Footprint>& maps, const std::vector<MapPair>& pairs,
                          std::optional<int> reference, const PlacementOptions& options,
                          const std::vector<InitialGuess>& guesses) {
  if (maps.empty() ||
      (reference && (*reference < 0 || *reference >= static_cast<int>(maps.size())))) {
    throw std::invalid_argument("placement needs maps, and a reference among them");
  }
  const std::vector<size_t> order = orderedPairs(maps.size(), pairs);
  std::vector<PairEvidence> evidence;
  for (const size_t i : order) {
    evidence.push_back(evidenceOf(pairs[i], maps[static_cast<size_t>(pairs[i].a)],
                                  maps[static_cast<size_t>(pairs[i].b)]));
  }
  if (options.is_calibrated) {
    weighByBaseRate(evidence);
  }
  weighByGuesses(guesses, maps, options.accept_from, evidence);
  const std::vector<SettledGroup> settled = groupMaps(maps, evidence, options);

  const std::vector<const InitialGuess*> guess_of = guessOfEachMap(guesses, maps.size());
  PlacementResult result;
  result.maps.resize(maps.size());
  for (size_t number = 0; number < settled.size(); ++number) {
    MapGroup group{settled[number].members.front(), settled[number].members};
    if (reference && std::binary_search(group.members.begin(), group.members.end(), *reference)) {
      group.reference = *reference;
    }
    placeMembers(settled[number], group, static_cast<int>(number), result.maps);
    const std::vector<OverruledGuess> overruled = overruledIn(group, guess_of, maps, result.maps);
    result.overruled.insert(result.overruled.end(), overruled.begin(), overruled.end());
    result.groups.push_back(std::move(group));
  }
  const auto largest = std::max_element(result.groups.begin(), result.groups.end(),
                                        [](const MapGroup& left, const MapGroup& right) {
                                          return left.members.size() < right.members.size();
                                        });
  result.largest = static_cast<int>(largest - result.groups.begin());

  result.settlements.resize(pairs.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const PairEvidence& pair = evidence[i];
    const MapPlacement& a = result.maps[static_cast<size_t>(pair.a)];
    const MapPlacement& b = result.maps[static_cast<size_t>(pair.b)];
    if (a.group == b.group && !pair.candidates.empty()) {
      result.settlements[order[i]] = nearest(pair, maps, inverse(a.pose) + b.pose);
    }
  }
  for (const SettledGroup& group : settled) {
    for (size_t i = 0; i < group.edges.size(); ++i) {
      const ChosenEdge& chosen = group.edges[i];
      const PairEvidence& pair = evidence[static_cast<size_t>(chosen.pair)];
      const Pose2D pose_b_in_a = inverse(group.poses[static_cast<size_t>(chosen.edge.a)]) +
                                 group.poses[static_cast<size_t>(chosen.edge.b)];
      const PoseGap gap =
          gapBetween(maps[static_cast<size_t>(pair.a)], maps[static_cast<size_t>(pair.b)],
                     chosen.edge.pose_b_in_a, pose_b_in_a);
      result.settlements[order[static_cast<size_t>(chosen.pair)]] =
          PairSettlement{true, chosen.candidate, gap.distance, gap.turn,
                         group.solution.edge_weights[i] * chosen.edge.covariance.inverse()};
    }
  }
  return result;
}

}  // namespace sbox
