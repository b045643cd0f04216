// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "sbox/report/report_json.h"

using namespace sbox;
using nlohmann::json;

namespace {

std::set<std::string> keys(const json& object) {
  std::set<std::string> out;
  for (const auto& item : object.items()) {
    out.insert(item.key());
  }
  return out;
}

MergeResult twoMergedMaps() {
  MergeResult result;
  result.status = MergeStatus::Merged;
  for (const char* name : {"a.gridmap", "b.gridmap"}) {
    MapOutcome map;
    map.name = name;
    map.width = 30;
    map.height = 20;
    map.resolution = static_cast<double>(0.05F);
    map.placed = true;
    map.features.lines.resize(31);
    map.features.vertical_points.resize(120);
    map.features.boxes.resize(84);
    result.maps.push_back(map);
  }
  MapPair pair{0, 1, {}};
  pair.result.verdict = Verdict::Accepted;
  pair.result.reason = "walls agree";
  pair.result.has_pose = true;
  pair.result.pose_b_in_a = {1.25, -0.5, 0.75};
  pair.result.covariance = PoseCovariance::Identity() * 0.01;
  pair.result.confidence = 0.98;
  pair.result.overlap_m2 = 41.5;
  pair.result.kalman = Pose2D{1.5, -0.5, 0.75};
  pair.result.matched_boxes = {{0, 1}, {2, 3}};
  pair.result.alternatives = {{{7, 8, 1.5}, 0.125}};
  result.maps[1].placement.pose = pair.result.pose_b_in_a;
  result.pairs.push_back(pair);
  MergedGroup merged;
  merged.members = {0, 1};
  merged.map = makeMap("merged", 40, 25, 0.05);
  merged.conflict_share = 0.0625;
  result.merged.push_back(merged);
  return result;
}

}  // namespace

TEST_CASE("the report holds what its contract names") {
  const json report = json::parse(reportJson(twoMergedMaps(), {"merged.gridmap"}));
  CHECK(keys(report) == std::set<std::string>{"version", "reference", "status", "maps", "pairs",
                                              "merged", "seconds"});
  CHECK(report["version"] == 1);
  CHECK(report["reference"] == 0);
  CHECK(report["status"] == "merged");

  const json& map = report["maps"][1];
  CHECK(keys(map) == std::set<std::string>{"file", "placed", "group", "reference", "pose",
                                           "covariance", "cells", "resolution", "features"});
  CHECK(map["file"] == "b.gridmap");
  CHECK(map["placed"] == true);
  CHECK(map["pose"] == json::parse(R"({"x": 1.25, "y": -0.5, "phi": 0.75})"));
  CHECK(map["cells"] == json::parse("[30, 20]"));
  CHECK(map["resolution"] == 0.05);
  CHECK(map["features"] == json::parse(R"({"lines": 31, "vertical_points": 120, "boxes": 84})"));

  const json& pair = report["pairs"][0];
  CHECK(keys(pair) == std::set<std::string>{"a", "b", "verdict", "reason", "pose", "covariance",
                                            "confidence", "matched_boxes", "overlap_m2", "kalman",
                                            "ceres", "alternatives", "settlement"});
  CHECK(pair["a"] == 0);
  CHECK(pair["b"] == 1);
  CHECK(pair["verdict"] == "accepted");
  CHECK(pair["covariance"] == json::parse("[[0.01, 0, 0], [0, 0.01, 0], [0, 0, 0.01]]"));
  CHECK(pair["matched_boxes"] == 2);
  CHECK(pair["kalman"]["x"] == 1.5);
  CHECK(pair["ceres"].is_null());
  CHECK(pair["alternatives"] ==
        json::parse(R"([{"pose": {"x": 7, "y": 8, "phi": 1.5}, "confidence": 0.125}])"));

  CHECK(report["merged"] ==
        json::parse(R"({"file": "merged.gridmap", "cells": [40, 25], "conflict_share": 0.0625})"));
  CHECK(keys(report["seconds"]) == std::set<std::string>{"load", "features", "matching",
                                                         "verification", "refinement", "fusion",
                                                         "save", "total"});
}

TEST_CASE("the report tells what the poses of all maps say of a pair") {
  MergeResult result = twoMergedMaps();
  CHECK(json::parse(reportJson(result, {}))["pairs"][0]["settlement"].is_null());
  result.pairs[0].settlement = PairSettlement{true, 1, 0.25, 0.5};
  CHECK(json::parse(reportJson(result, {}))["pairs"][0]["settlement"] ==
        json::parse(R"({"agrees": true, "candidate": 1, "distance": 0.25, "turn": 0.5})"));
}

TEST_CASE("what is not known is null in the report") {
  MergeResult result = twoMergedMaps();
  result.merged.clear();
  result.status = MergeStatus::Refused;
  result.pairs[0].result = {};
  const json report = json::parse(reportJson(result, {}));
  CHECK(report["status"] == "refused");
  CHECK(report["merged"].is_null());
  CHECK(report["pairs"][0]["verdict"] == "rejected");
  CHECK(report["pairs"][0]["pose"].is_null());
  CHECK(report["pairs"][0]["covariance"].is_null());
  CHECK(report["pairs"][0]["alternatives"] == json::array());
}

TEST_CASE("the report stays JSON whatever the file names and numbers") {
  MergeResult result = twoMergedMaps();
  result.maps[0].name = "\xff\"\\\n.gridmap";
  result.maps[0].placement.pose.x = std::numeric_limits<double>::quiet_NaN();
  const json report = json::parse(reportJson(result, {"merged.gridmap"}));
  CHECK(report["maps"][0]["file"].get<std::string>().find(".gridmap") != std::string::npos);
  CHECK(report["maps"][0]["pose"]["x"].is_null());
}

TEST_CASE("groups beyond the main one are named beside it") {
  MergeResult result = twoMergedMaps();
  result.merged.push_back(result.merged[0]);
  result.merged[1].group = 3;
  result.merged[1].reference = 1;
  const json report = json::parse(reportJson(result, {"m.gridmap", "m_group3.gridmap"}));
  REQUIRE(report["other_groups"].size() == 1);
  CHECK(report["other_groups"][0]["file"] == "m_group3.gridmap");
  CHECK(report["other_groups"][0]["group"] == 3);
  CHECK(report["other_groups"][0]["reference"] == 1);
}
