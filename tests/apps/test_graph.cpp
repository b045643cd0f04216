// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The graph of poses by the eyes of MRPT's own tool, and rough poses from a file.
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "apps/check_contains.h"
#include "apps/command.h"
#include "apps/office.h"
#include "catch.h"
#include "sbox/io/save_map.h"

using namespace sbox;
using namespace sbox::test;

namespace {

/// Three parts of one floor, each of which overlaps the others.
void saveThreeParts(const ScratchFolder& folder) {
  const Map floor = office("floor", 1);
  saveMap(cutColumns(floor, "a", 0, 400, {-1, 2, 0}), (folder / "a.yaml").string());
  saveMap(cutColumns(floor, "b", 60, 480, {3, -4.5, 0.7}), (folder / "b.yaml").string());
  saveMap(cutColumns(floor, "c", 30, 440, {0, 0, -2}), (folder / "c.yaml").string());
}

std::map<int, Pose2D> vertices(const std::filesystem::path& path) {
  std::map<int, Pose2D> poses;
  std::istringstream lines(contents(path));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    int map = 0;
    Pose2D pose;
    if (words >> key >> map >> pose.x >> pose.y >> pose.phi && key.rfind("VERTEX", 0) == 0) {
      poses[map] = pose;
    }
  }
  return poses;
}

}  // namespace

TEST_CASE("graph-slam of MRPT optimises the graph to the same poses") {
  const ScratchFolder folder;
  saveThreeParts(folder);
  const Outcome outcome = runMerge(folder.path(), {"--in", "a.yaml", "b.yaml", "c.yaml",
                                                   "--reference", "1", "--graph", "g.graph"});
  REQUIRE(outcome.exit_code == 0);
  const std::map<int, Pose2D> ours = vertices(folder / "g.graph");
  REQUIRE(ours.size() == 3);
  CHECK(ours.at(1).x == 0);
  if (std::system("command -v graph-slam > /dev/null") != 0) {  // NOLINT: no input
    WARN("skipped: graph-slam is not installed (package mrpt-apps)");
    return;
  }
  const std::string command = "cd '" + folder.path().string() +
                              "' && graph-slam --2d --levmarq -q -i g.graph -o o.graph > log 2>&1";
  REQUIRE(std::system(command.c_str()) == 0);  // NOLINT: a folder of our own
  CHECK(contents(folder / "log").find("unknown entry") == std::string::npos);
  const std::map<int, Pose2D> theirs = vertices(folder / "o.graph");
  REQUIRE(theirs.size() == 3);
  for (const auto& [map, pose] : ours) {
    // The tool begins at the first map, whichever is fixed.
    const Pose2D in_reference = inverse(theirs.at(1)) + theirs.at(map);
    CHECK(in_reference.x == Approx(pose.x).margin(0.02));
    CHECK(in_reference.y == Approx(pose.y).margin(0.02));
    CHECK(std::abs(wrapAngle(in_reference.phi - pose.phi)) < 0.002);
  }
}

TEST_CASE("rough poses are taken, and a file of them that cannot be used is one line") {
  const ScratchFolder folder;
  saveThreeParts(folder);
  std::ofstream(folder / "good.txt") << "a.yaml 0 0 0 1 10\nb.yaml 30 0 0 1 10\n";
  CHECK(runMerge(folder.path(), {"--in", "a.yaml", "b.yaml", "--initial", "good.txt"}).exit_code ==
        0);
  std::ofstream(folder / "bad.txt") << "a.yaml 0 0 0 1\n";
  const Outcome bad = runMerge(folder.path(), {"--in", "a.yaml", "b.yaml", "--initial", "bad.txt"});
  CHECK(bad.exit_code == 1);
  CHECK(bad.err ==
        "sbox-merge: bad.txt: line 1 must be FILE x y phi sigma_xy sigma_phi, in metres and "
        "degrees\n");
  CHECK(runMerge(folder.path(), {"--in", "a.yaml", "b.yaml", "--initial", "no.txt"}).exit_code ==
        1);
}
