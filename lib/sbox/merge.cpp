// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/merge.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sbox/bending/bend_maps.h"
#include "sbox/core/parallel.h"
#include "sbox/core/stopwatch.h"
#include "sbox/placement/place_maps.h"

namespace sbox {
namespace {

MergedGroup fuseGroup(const std::vector<Map>& maps, const PlacementResult& placed, int number,
                      const MergeOptions& options) {
  const MapGroup& group = placed.groups[static_cast<size_t>(number)];
  std::vector<PlacedMap> members;
  size_t reference = 0;
  for (const int member : group.members) {
    if (member == group.reference) {
      reference = members.size();
    }
    members.push_back(
        {&maps[static_cast<size_t>(member)], placed.maps[static_cast<size_t>(member)].pose});
  }
  FusionOptions fusion = options.fusion;
  fusion.threads = options.threads;
  MergedGroup merged{number, group.reference, group.members, {}, 0, {}};
  std::vector<BentMap> bent;
  if (options.bend) {
    const RankingOptions& ranking = options.pair.ranking;
    bent = bendMaps(members, reference,
                    {options.pair.features, ranking.drift, ranking.bent_evidence, fusion});
    for (size_t i = 0; i < members.size(); ++i) {
      members[i] = {&bent[i].map, Pose2D()};
      merged.shifts.push_back(bent[i].shift);
    }
  }
  FusionResult fused = fuseMaps(members, reference, fusion);
  merged.map = std::move(fused.merged);
  merged.conflict_share = fused.conflict_share;
  return merged;
}

/// The largest group first; the others, in their order, if all are asked for.
std::vector<int> groupsToFuse(const PlacementResult& placed, bool all_groups) {
  std::vector<int> numbers;
  if (placed.groups[static_cast<size_t>(placed.largest)].members.size() >= 2) {
    numbers.push_back(placed.largest);
  }
  for (int number = 0; all_groups && number < static_cast<int>(placed.groups.size()); ++number) {
    if (number != placed.largest &&
        placed.groups[static_cast<size_t>(number)].members.size() >= 2) {
      numbers.push_back(number);
    }
  }
  return numbers;
}

MapOutcome outcomeOf(const Map& map, const MapPlacement& placement, const FeatureSet& features) {
  MapOutcome outcome;
  outcome.name = map.name;
  outcome.width = map.width();
  outcome.height = map.height();
  outcome.resolution = map.resolution();
  outcome.placement = placement;
  outcome.features = features;
  return outcome;
}

/// Merged map of the largest group, and of the others if all are asked for.
std::vector<MergedGroup> fuseGroups(const std::vector<Map>& maps, const PlacementResult& placed,
                                    const MergeOptions& options, const ProgressFunction& tell) {
  const std::vector<int> groups = groupsToFuse(placed, options.all_groups);
  StageProgress progress(tell, "fusion", static_cast<int>(groups.size()));
  std::vector<MergedGroup> merged;
  for (const int group : groups) {
    merged.push_back(fuseGroup(maps, placed, group, options));
    progress.partDone();
  }
  return merged;
}

/// Fills in status, reference and which maps are placed, by what was merged.
void concludeStatus(std::optional<int> reference, MergeResult& result) {
  result.reference = reference.value_or(0);
  if (result.merged.empty()) {
    return;
  }
  const MergedGroup& main_group = result.merged.front();
  result.reference = main_group.reference;
  for (const int member : main_group.members) {
    result.maps[static_cast<size_t>(member)].placed = true;
  }
  result.status =
      main_group.members.size() == result.maps.size() ? MergeStatus::Merged : MergeStatus::Partly;
}

}  // namespace

MergeResult mergeMaps(const std::vector<Map>& maps, const MergeOptions& options, MatchStore& known,
                      const ProgressFunction& progress) {
  if (maps.size() < 2) {
    throw std::invalid_argument("merging needs at least two maps");
  }
  const Stopwatch total_stopwatch;
  MergeResult result;
  // Section 3.1: features, once a map.
  extractAll(maps, options, known, progress);
  result.seconds.features = total_stopwatch.seconds();
  // Section 3.2: matching, of the pairs that are worth it.
  const std::vector<Footprint> footprints = footprintsOf(maps, statesOf(options), options.threads);
  const Stopwatch retrieval_stopwatch;
  const std::vector<PairIndex> pairs = pairsToMatch(footprints, options, known, progress);
  result.seconds.matching = retrieval_stopwatch.seconds();
  for (const PairIndex& pair : matchPairs(pairs, options, known, progress)) {
    const PairSeconds& seconds = known.results.at(pair).seconds;
    result.seconds.matching += seconds.matching;
    result.seconds.verification += seconds.verification;
    result.seconds.refinement += seconds.refinement;
  }
  result.pairs = matchedPairs(pairs, known);
  // Which maps belong together, and where each lies.
  PlacementOptions placement = options.placement;
  placement.accept_from = options.pair.verdict.accept_from;
  placement.is_calibrated = options.method == Method::Boxes;
  const PlacementResult placed =
      placeMaps(footprints, result.pairs, options.reference, placement, options.initial);
  for (size_t i = 0; i < maps.size(); ++i) {
    const FeatureSet& features = featureSetOf(*known.features[i]);
    result.maps.push_back(outcomeOf(maps[i], placed.maps[i], features));
  }
  for (size_t i = 0; i < result.pairs.size(); ++i) {
    result.pairs[i].settlement = placed.settlements[i];
  }
  result.overruled = placed.overruled;
  // Section 3.3: fusion.
  const Stopwatch fusion_stopwatch;
  result.merged = fuseGroups(maps, placed, options, progress);
  result.seconds.fusion = fusion_stopwatch.seconds();
  concludeStatus(options.reference, result);
  result.seconds.total = total_stopwatch.seconds();
  return result;
}

MergeResult mergeMaps(const std::vector<Map>& maps, const MergeOptions& options,
                      const ProgressFunction& progress) {
  MatchStore known;
  return mergeMaps(maps, options, known, progress);
}

}  // namespace sbox
