// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/merge.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sbox/core/parallel.h"
#include "sbox/match_all.h"

namespace sbox {
namespace {

/// Features of each map, then all pairs, by the method chosen.
MatchedMaps match(const std::vector<Map>& maps, const MergeOptions& options,
                  const ProgressFunction& progress) {
  if (options.method == Method::Boxes) {
    return matchAll(
        maps, [&](const Map& map) { return extractFeatures(map, options.pair.features); },
        [&](const MapFeatures& a, const MapFeatures& b) { return matchPair(a, b, options.pair); },
        options.threads, progress);
  }
  return matchAll(
      maps, [&](const Map& map) { return extractPaperFeatures(map, options.paper); },
      [&](const PaperFeatures& a, const PaperFeatures& b) {
        return matchPaper(a, b, options.paper);
      },
      options.threads, progress);
}

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
  FusionResult fused = fuseMaps(members, reference, fusion);
  return {number, group.reference, group.members, std::move(fused.merged), fused.conflict_share};
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

MapOutcome outcomeOf(const Map& map, const MapPlacement& placement, FeatureSet features) {
  MapOutcome outcome;
  outcome.name = map.name;
  outcome.width = map.width();
  outcome.height = map.height();
  outcome.resolution = map.resolution();
  outcome.placement = placement;
  outcome.features = std::move(features);
  return outcome;
}

}  // namespace

MergeResult mergeMaps(const std::vector<Map>& maps, const MergeOptions& options,
                      const ProgressFunction& progress) {
  if (maps.size() < 2) {
    throw std::invalid_argument("merging needs at least two maps");
  }
  const Stopwatch stopwatch;
  MatchedMaps matched = match(maps, options, progress);
  std::vector<Footprint> footprints(maps.size());
  parallelFor(static_cast<int>(maps.size()), options.threads, [&](int i) {
    footprints[static_cast<size_t>(i)] = footprintOf(maps[static_cast<size_t>(i)]);
  });
  const PlacementResult placed =
      placeMaps(footprints, matched.pairs, options.reference, options.placement, options.initial);
  for (size_t i = 0; i < matched.pairs.size(); ++i) {
    matched.pairs[i].settlement = placed.settlements[i];
  }

  MergeResult result;
  const Stopwatch fusion_stopwatch;
  const std::vector<int> groups = groupsToFuse(placed, options.all_groups);
  StageProgress fusion_progress(progress, "fusion", static_cast<int>(groups.size()));
  for (const int group : groups) {
    result.merged.push_back(fuseGroup(maps, placed, group, options));
    fusion_progress.partDone();
  }
  result.seconds.fusion = fusion_stopwatch.seconds();

  for (size_t i = 0; i < maps.size(); ++i) {
    result.maps.push_back(outcomeOf(maps[i], placed.maps[i], std::move(matched.features[i])));
  }
  result.reference = options.reference.value_or(0);
  if (!result.merged.empty()) {
    const MergedGroup& main_group = result.merged.front();
    result.reference = main_group.reference;
    for (const int member : main_group.members) {
      result.maps[static_cast<size_t>(member)].placed = true;
    }
    result.status =
        main_group.members.size() == maps.size() ? MergeStatus::Merged : MergeStatus::Partly;
  }
  result.seconds.features = matched.feature_seconds;
  for (const MapPair& pair : matched.pairs) {
    result.seconds.matching += pair.result.seconds.matching;
    result.seconds.verification += pair.result.seconds.verification;
    result.seconds.refinement += pair.result.seconds.refinement;
  }
  result.pairs = std::move(matched.pairs);
  result.seconds.total = stopwatch.seconds();
  return result;
}

}  // namespace sbox
