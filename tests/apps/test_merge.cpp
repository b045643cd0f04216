// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the command gives for maps that fit and for maps that do not.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/check_contains.h"
#include "apps/command.h"
#include "apps/office.h"
#include "catch.h"
#include "sbox/io/load_map.h"
#include "sbox/io/save_map.h"

using namespace sbox;
using namespace sbox::test;
namespace fs = std::filesystem;
using nlohmann::json;
using Words = std::vector<std::string>;

namespace {

/// Two overlapping parts of one floor whose frames lie apart by a known pose, and a hall elsewhere.
struct Floors {
  ScratchFolder folder;
  Pose2D pose_b_in_a;

  Floors() {
    const Map floor = office("floor", 1);
    const Pose2D corner_a{-1, 2, 0}, corner_b{3, -4.5, 0.7};
    saveMap(cutColumns(floor, "a", 0, 400, corner_a), (folder / "a.yaml").string());
    saveMap(cutColumns(floor, "b", 60, 480, corner_b), folder / "b.yaml");
    saveMap(roundHall("hall"), folder / "hall.gridmap");
    pose_b_in_a = corner_a + Pose2D{3, 0, 0} + inverse(corner_b);
  }
  [[nodiscard]] Outcome run(const Words& arguments) const {
    return runMerge(folder.path(), arguments);
  }
  [[nodiscard]] json report() const { return json::parse(contents(folder / "r.json")); }
};

void checkPose(const json& pose, const Pose2D& expected) {
  CHECK(pose["x"].get<double>() == Approx(expected.x).margin(0.1));
  CHECK(pose["y"].get<double>() == Approx(expected.y).margin(0.1));
  CHECK(std::abs(wrapAngle(pose["phi"].get<double>() - expected.phi)) < M_PI / 180);
}

}  // namespace

TEST_CASE("two parts of a floor are merged where they belong") {
  const Floors floors;
  const Outcome outcome = floors.run({"--in", "a.yaml", "b.yaml", "--report", "r.json"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  checkContains(outcome.out, "merged.gridmap: 2 of 2 maps merged, b.yaml in a.yaml: x ");
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 1);
  const json report = floors.report();
  CHECK(report["status"] == "merged");
  checkPose(report["pairs"][0]["pose"], floors.pose_b_in_a);
  checkPose(report["maps"][1]["pose"], floors.pose_b_in_a);
  CHECK(report["seconds"]["total"].get<double>() > 0);
  const Map merged = loadMap((floors.folder / "merged.gridmap").string());
  CHECK(report["merged"]["cells"] == json({merged.width(), merged.height()}));
  CHECK(fs::exists(floors.folder / "merged.png"));
}

TEST_CASE("swapping the maps gives the inverse, and so does another reference") {
  const Floors floors;
  REQUIRE(floors.run({"--in", "b.yaml", "a.yaml", "--report", "r.json"}).exit_code == 0);
  checkPose(floors.report()["maps"][1]["pose"], inverse(floors.pose_b_in_a));
  REQUIRE(floors.run({"--in", "a.yaml", "b.yaml", "--report", "r.json", "--reference", "1"})
              .exit_code == 0);
  const json report = floors.report();
  CHECK(report["reference"] == 1);
  checkPose(report["maps"][0]["pose"], inverse(floors.pose_b_in_a));
  checkPose(report["pairs"][0]["pose"], floors.pose_b_in_a);
}

TEST_CASE("a map merged with itself gives the identity") {
  const Floors floors;
  REQUIRE(floors.run({"--in", "a.yaml", "a.yaml", "--report", "r.json"}).exit_code == 0);
  checkPose(floors.report()["maps"][1]["pose"], {});
}

TEST_CASE("maps of different places are refused and nothing is merged") {
  const Floors floors;
  std::ofstream(floors.folder / "merged.gridmap") << "precious";
  const Outcome outcome = floors.run({"--in", "a.yaml", "hall.gridmap", "--report", "r.json"});
  CHECK(outcome.exit_code == 3);
  checkContains(outcome.out, "0 of 2 maps merged, hall.gridmap in a.yaml: ");
  CHECK(contents(floors.folder / "merged.gridmap") == "precious");
  CHECK_FALSE(fs::exists(floors.folder / "merged.png"));
  CHECK(outcome.err ==
        "sbox-merge: warning: merged.gridmap is left as it was, as nothing was merged\n");
  const json report = floors.report();
  CHECK(report["status"] == "refused");
  CHECK(report["merged"].is_null());
  CHECK_FALSE(report["pairs"][0]["reason"].get<std::string>().empty());
}

TEST_CASE("of more maps the largest group is merged, or every group if asked for") {
  const Floors floors;
  const auto with = beginningWith({"--in", "hall.gridmap", "a.yaml", "b.yaml"});
  const Outcome outcome = floors.run(with({"--report", "r.json"}));
  CHECK(outcome.exit_code == 3);
  checkContains(outcome.out, "merged.gridmap: 2 of 3 maps merged in a.yaml\n");
  checkContains(outcome.out, "hall.gridmap: left out; ");
  const json report = floors.report();
  CHECK(report["status"] == "partly");
  CHECK(report["reference"] == 1);
  CHECK(report["maps"][0]["placed"] == false);
  CHECK(report["maps"][1]["group"] == report["maps"][2]["group"]);
  CHECK(report["maps"][0]["group"] != report["maps"][1]["group"]);

  const Outcome wished = floors.run(with({"--reference", "0"}));
  checkContains(wished.err, "warning: hall.gridmap is not part of the merged map");
}

TEST_CASE("every group is merged if asked for") {
  const Floors floors;
  saveMap(office("other", 5), (floors.folder / "other.gridmap").string());
  // The published method takes few agreeing boxes for proof; parts of one floor have hundreds.
  std::ofstream(floors.folder / "c.ini") << "[paper.matching]\nmin_agreeing = 150\n";
  const Outcome outcome = floors.run({"--in", "other.gridmap", "a.yaml", "b.yaml", "hall.gridmap",
                                      "other.gridmap", "a.yaml", "--method", "paper", "--config",
                                      "c.ini", "--all-groups", "--report", "r.json"});
  CHECK(outcome.exit_code == 3);
  checkContains(outcome.out, "merged.gridmap: 3 of 6 maps merged in a.yaml\n");
  checkContains(outcome.out, "merged_group0.gridmap: 2 of 6 maps merged in other.gridmap\n");
  checkContains(outcome.out, "hall.gridmap: left out; ");
  const json report = floors.report();
  REQUIRE(report["other_groups"].size() == 1);
  CHECK(report["other_groups"][0]["file"] == "merged_group0.gridmap");
  CHECK(report["maps"][4]["group"] == 0);
  CHECK(report["maps"][4]["placed"] == false);
  for (const char* file :
       {"merged.gridmap", "merged.png", "merged_group0.gridmap", "merged_group0.png"}) {
    CHECK(fs::exists(floors.folder / file));
  }
}

TEST_CASE("the same maps give the same bytes on any number of threads") {
  const Floors floors;
  const auto run = [&](const std::string& threads, const std::string& name) {
    return floors.run({"--in", "a.yaml", "b.yaml", "hall.gridmap", "--threads", threads, "--out",
                       name, "--pictures", name + ".d"});
  };
  CHECK(run("1", "one.gridmap").exit_code == 3);
  CHECK(run("3", "three.gridmap").exit_code == 3);
  CHECK(contents(floors.folder / "one.gridmap") == contents(floors.folder / "three.gridmap"));
  for (const std::string& picture : listing(floors.folder / "one.gridmap.d")) {
    INFO(picture);
    CHECK(contents(floors.folder / "one.gridmap.d" / picture) ==
          contents(floors.folder / "three.gridmap.d" / picture));
  }
}

TEST_CASE("shares of the pairs, matched apart and joined, give the same files") {
  const Floors floors;
  const Words in{"--in", "a.yaml", "b.yaml", "hall.gridmap"};
  const auto run = [&](const Words& more) {
    Words all = in;
    all.insert(all.end(), more.begin(), more.end());
    return floors.run(all);
  };
  CHECK(run({"--out", "alone.gridmap", "--html", "alone.html"}).exit_code == 3);
  const Outcome first = run({"--pairs", "1/2", "--report", "1.json"});
  CHECK(first.exit_code == 0);
  CHECK(first.out == "1.json: 2 pairs matched, share 1 of 2\n");
  CHECK(run({"--pairs", "2/2", "--report", "2.json"}).exit_code == 0);
  const Words before = listing(floors.folder.path());
  CHECK(std::find(before.begin(), before.end(), "merged.gridmap") == before.end());
  CHECK(run({"--join", "2.json", "1.json", "--out", "joined.gridmap", "--html", "joined.html"})
            .exit_code == 3);
  CHECK(contents(floors.folder / "joined.gridmap") == contents(floors.folder / "alone.gridmap"));
  const auto page = [&](const std::string& name) {
    std::string text = contents(floors.folder / (name + ".html"));
    for (size_t at = 0; (at = text.find(name + ".gridmap", at)) != std::string::npos;) {
      text.replace(at, name.size(), "merged");
    }
    return text;
  };
  CHECK(page("joined") == page("alone"));
}

TEST_CASE("every kind of output is written, and pictures into a new folder") {
  const Floors floors;
  for (const char* name : {"m.gridmap.gz", "m.yaml"}) {
    const Outcome outcome =
        floors.run({"--in", "a.yaml", "b.yaml", "--out", name, "--pictures", "new/pictures", "-q"});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.empty());
    CHECK(loadMap((floors.folder / name).string()).width() > 400);
    CHECK(fs::exists(floors.folder / "m.png"));
  }
  CHECK(listing(floors.folder / "new/pictures") == Words{"boxes_a_b.png", "features_a.png",
                                                         "features_b.png", "merged.png",
                                                         "overlay_a_b.png"});
}

TEST_CASE("pictures beside the merged map do not take its picture's place") {
  const Floors floors;
  CHECK(floors.run({"--in", "a.yaml", "b.yaml", "--pictures", "."}).exit_code == 0);
  CHECK(fs::exists(floors.folder / "merged.png"));
  CHECK(fs::exists(floors.folder / "merged_view.png"));
}

TEST_CASE("-v tells on stderr what was found") {
  const Floors floors;
  const Outcome outcome = floors.run({"--in", "a.yaml", "b.yaml", "-v"});
  checkContains(outcome.err, "a.yaml: 400 x 320 cells of 0.050 m, ");
  checkContains(outcome.err, " vertical points, ");
  checkContains(outcome.err, "b.yaml in a.yaml: accepted, ");
  checkContains(outcome.err, "group 0 merged: ");
  checkContains(outcome.err, "seconds: total ");
}

TEST_CASE("the dumped configuration is read back and counts") {
  const Floors floors;
  const Outcome defaults = floors.run({"--dump-config"});
  CHECK(defaults.exit_code == 0);
  std::ofstream(floors.folder / "all.ini") << defaults.out;
  CHECK(floors.run({"--dump-config", "--config", "all.ini"}).out == defaults.out);
  std::ofstream(floors.folder / "strict.ini") << "[placement]\nmin_confidence = 1\n";
  CHECK(floors.run({"--in", "a.yaml", "b.yaml", "--config", "strict.ini"}).exit_code == 3);
  checkContains(floors.run({"--dump-config", "--fusion", "table"}).out, "rule = table");
}

TEST_CASE("--bend says how far each map was bent, and leaves the poses") {
  const Floors floors;
  CHECK(floors.run({"--in", "a.yaml", "b.yaml", "--report", "r.json"}).exit_code == 0);
  const json rigid = floors.report();
  CHECK_FALSE(rigid["merged"].contains("bent"));
  const Outcome outcome =
      floors.run({"--in", "a.yaml", "b.yaml", "--bend", "-v", "--report", "r.json"});
  CHECK(outcome.exit_code == 0);
  checkContains(outcome.err, "b.yaml: bent by 0.0");
  const json bent = floors.report();
  CHECK(bent["maps"][1]["pose"] == rigid["maps"][1]["pose"]);
  REQUIRE(bent["merged"]["bent"].size() == 2);
  CHECK(bent["merged"]["bent"][0]["map"] == 0);
  CHECK(bent["merged"]["bent"][0]["shift"] == 0);
  CHECK(bent["merged"]["conflict_share"] <= rigid["merged"]["conflict_share"]);
}

TEST_CASE("images take their cell size from --resolution") {
  const Floors floors;
  saveMap(loadMap((floors.folder / "a.yaml").string()), (floors.folder / "a.png").string());
  REQUIRE(floors.run({"--in", "a.png", "a.png", "--resolution", "0.05", "--report", "r.json"})
              .exit_code == 0);
  CHECK(floors.report()["maps"][0]["resolution"] == 0.05);
}

TEST_CASE("the page and the transforms are written where something was merged") {
  const Floors floors;
  REQUIRE(
      floors.run({"--in", "a.yaml", "b.yaml", "--html", "r.html", "--tf", "tf.yaml"}).exit_code ==
      0);
  checkContains(contents(floors.folder / "r.html"), "<title>2 of 2 maps merged</title>");
  checkContains(contents(floors.folder / "tf.yaml"), "child_frame_id: b/map");
  REQUIRE(floors.run({"--in", "a.yaml", "b.yaml", "--tf", "tf.sh"}).exit_code == 0);
  checkContains(contents(floors.folder / "tf.sh"), "ros2 run tf2_ros static_transform_publisher");
  REQUIRE(floors.run({"--in", "a.yaml", "hall.gridmap", "--html", "no.html", "--tf", "no.yaml"})
              .exit_code == 3);
  checkContains(contents(floors.folder / "no.html"), "<title>0 of 2 maps merged</title>");
  CHECK_FALSE(fs::exists(floors.folder / "no.yaml"));
}
