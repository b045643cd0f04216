// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/report_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sbox/io/pair_json.h"
#include "sbox/report/json_layout.h"

namespace sbox {
namespace {

using Json = nlohmann::ordered_json;

constexpr int report_version = 1;

/// MRPT keeps cell sizes as floats: 0.05 m reads 0.0500000007.
double withoutFloatNoise(double metres) { return std::round(metres * 1e7) / 1e7; }

double microseconds(double seconds) { return std::round(seconds * 1e6) / 1e6; }

Json mapJson(const MapOutcome& map) {
  return {{"file", map.name},
          {"placed", map.placed},
          {"group", map.placement.group},
          {"reference", map.placement.reference},
          {"pose", poseJson(map.placement.pose)},
          {"covariance", covarianceJson(map.placement.covariance)},
          {"cells", {map.width, map.height}},
          {"resolution", withoutFloatNoise(map.resolution)},
          {"features",
           {{"lines", map.features.lines.size()},
            {"vertical_points", map.features.vertical_points.size()},
            {"boxes", map.features.boxes.size()}}}};
}

/// What the poses of all maps say of the pair.
Json settlementJson(const std::optional<PairSettlement>& settlement) {
  if (!settlement) {
    return nullptr;
  }
  return {{"agrees", settlement->agrees},
          {"candidate", settlement->candidate},
          {"distance", settlement->distance},
          {"turn", settlement->turn}};
}

Json settledPairJson(const MapPair& pair) {
  Json json = pairJson(pair);
  json["settlement"] = settlementJson(pair.settlement);
  return json;
}

Json mergedJson(const MergedGroup& merged, const std::string& file) {
  Json json{{"file", file},
            {"cells", {merged.map.width(), merged.map.height()}},
            {"conflict_share", merged.conflict_share}};
  for (size_t i = 0; i < merged.shifts.size(); ++i) {
    json["bent"].push_back({{"map", merged.members[i]}, {"shift", merged.shifts[i]}});
  }
  return json;
}

Json secondsJson(const StageSeconds& seconds) {
  return {{"load", microseconds(seconds.load)},
          {"features", microseconds(seconds.features)},
          {"matching", microseconds(seconds.matching)},
          {"verification", microseconds(seconds.verification)},
          {"refinement", microseconds(seconds.refinement)},
          {"fusion", microseconds(seconds.fusion)},
          {"save", microseconds(seconds.save)},
          {"total", microseconds(seconds.total)}};
}

}  // namespace

std::string reportJson(const MergeResult& result, const std::vector<std::string>& merged_files) {
  Json report{{"version", report_version},
              {"reference", result.reference},
              {"status", toString(result.status)},
              {"maps", Json::array()},
              {"pairs", Json::array()},
              {"merged", nullptr}};
  for (const MapOutcome& map : result.maps) {
    report["maps"].push_back(mapJson(map));
  }
  for (const MapPair& pair : result.pairs) {
    report["pairs"].push_back(settledPairJson(pair));
  }
  const size_t written = std::min(result.merged.size(), merged_files.size());
  if (written > 0) {
    report["merged"] = mergedJson(result.merged[0], merged_files[0]);
  }
  for (size_t i = 1; i < written; ++i) {
    Json group = mergedJson(result.merged[i], merged_files[i]);
    group["group"] = result.merged[i].group;
    group["reference"] = result.merged[i].reference;
    report["other_groups"].push_back(group);
  }
  report["seconds"] = secondsJson(result.seconds);
  return layOutJson(report);
}

}  // namespace sbox
