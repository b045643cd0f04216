// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "catch.h"
#include "sbox-bench/set_score.h"

using namespace sbox::bench;

TEST_CASE("three maps of one building are one group with all pairs right") {
  const PairFolder folder = readPairFolder(SBOX_DATASETS "/sena");
  const std::vector<MapSet> sets = readSets(folder);
  REQUIRE(sets.size() == 1);
  CHECK(sets[0].maps.size() == 3);
  SetScore score = scoreSet(folder, sets[0], 1);
  CHECK(score.groups == 1);
  CHECK(score.right == folder.pairs.size());
  // The same answers are wrong once the annotation lies elsewhere.
  PairFolder moved = folder;
  for (AnnotatedPair& pair : moved.pairs) {
    for (sbox::Point2D& point : pair.points_b) {
      point.x += 100;
    }
  }
  score = scoreSet(moved, sets[0], 1);
  CHECK(score.right == 0);
  CHECK(score.wrong == folder.pairs.size());
}

TEST_CASE("sets are read from sets.json beside the pairs") {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "sbox-test-sets";
  std::filesystem::create_directory(path);
  PairFolder folder;
  folder.path = path.string();
  folder.pairs.resize(1);
  folder.pairs[0].a = "a";
  folder.pairs[0].b = "b";
  std::ofstream(path / "sets.json")
      << R"({"sets": [{"name": "some", "maps": [{"map": "b"}, {"map": "c"}]}]})";
  const std::vector<MapSet> sets = readSets(folder);
  std::ofstream(path / "sets.json") << R"({"sets": 3})";
  CHECK_THROWS_AS(readSets(folder), std::runtime_error);
  std::filesystem::remove_all(path);
  REQUIRE(sets.size() == 2);
  CHECK(sets[0].maps == std::vector<std::string>{"a", "b"});
  CHECK(sets[1].name == "some");
  CHECK(sets[1].maps == std::vector<std::string>{"b", "c"});
}
