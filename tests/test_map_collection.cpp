// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <stdexcept>
#include <string>

#include "catch.h"
#include "drawing.h"
#include "sbox/map_collection.h"
#include "sbox/merge.h"
#include "sbox/report/report_json.h"

using namespace sbox;

namespace {

Map partOfOffice(const char* name, const Pose2D& pose, const Point2D& low, const Point2D& high) {
  Map map = test::exploreMap(test::officeFloor(), pose, 0.1, {low, high});
  map.name = name;
  return map;
}

Map west() { return partOfOffice("west", {2, 1, 0}, {-1, -1}, {16, 15}); }
Map east() { return partOfOffice("east", {15, -6, -0.9}, {5, -1}, {25, 15}); }
Map north() { return partOfOffice("north", {0, 0, 2.2}, {-1, 4}, {25, 15}); }

/// The report but for what differs between two runs.
std::string reportOf(MergeResult result) {
  result.seconds = {};
  return reportJson(result, {"merged.gridmap"});
}

/// How many parts each stage had.
struct Work {
  std::map<std::string, int> parts;

  ProgressFunction listener() {
    return [this](const std::string& stage, int, int total) { parts[stage] = total; };
  }
};

}  // namespace

TEST_CASE("a map that is added costs its own pairs only, and the result is that of all maps",
          "[map_collection]") {
  MapCollection maps;
  CHECK(maps.add(west()) == 0);
  CHECK(maps.add(east()) == 1);
  CHECK(reportOf(maps.merge()) == reportOf(mergeMaps({west(), east()})));
  CHECK(maps.add(north()) == 2);
  Work work;
  CHECK(reportOf(maps.merge(work.listener())) == reportOf(mergeMaps({west(), east(), north()})));
  CHECK(work.parts["features"] == 1);
  CHECK(work.parts["pairs"] == 2);
  CHECK(maps.merge(work.listener()).pairs.size() == 3);
  CHECK(work.parts["features"] == 0);
  CHECK(work.parts["pairs"] == 0);
}

TEST_CASE("a map that is replaced is matched anew, the others are not", "[map_collection]") {
  MapCollection maps;
  maps.add(west());
  maps.add(test::exploreMap(test::randomFloor(3), {}, 0.1));
  maps.add(north());
  CHECK(maps.merge().status == MergeStatus::Partly);
  maps.replace(1, east());
  Work work;
  const MergeResult result = maps.merge(work.listener());
  CHECK(work.parts["features"] == 1);
  CHECK(work.parts["pairs"] == 2);
  CHECK(result.status == MergeStatus::Merged);
  CHECK(reportOf(result) == reportOf(mergeMaps({west(), east(), north()})));
  CHECK_THROWS_AS(maps.replace(3, east()), std::out_of_range);
}

TEST_CASE("where each map may have few partners, adding maps one by one changes nothing",
          "[map_collection]") {
  MergeOptions options;
  options.retrieval.partners = 1;
  MapCollection maps(options);
  const std::vector<Map> all{west(), test::exploreMap(test::randomFloor(3), {}, 0.1), east(),
                             north()};
  for (const Map& map : all) {
    maps.add(map);
    if (maps.maps().size() >= 2) {
      CHECK(maps.merge().maps.size() == maps.maps().size());
    }
  }
  const MergeResult result = maps.merge();
  CHECK(reportOf(result) == reportOf(mergeMaps(all, options)));
  CHECK(result.pairs.size() < 6);
  CHECK(result.merged.at(0).members == std::vector<int>{0, 2, 3});
}

TEST_CASE("an interrupted merge leaves a collection that can be merged", "[map_collection]") {
  MapCollection maps;
  maps.add(west());
  maps.add(east());
  const auto interrupt = [](const std::string& stage, int, int) {
    if (stage == "pairs") {
      throw std::runtime_error("stop");
    }
  };
  CHECK_THROWS_AS(maps.merge(interrupt), std::runtime_error);
  CHECK(reportOf(maps.merge()) == reportOf(mergeMaps({west(), east()})));
}
