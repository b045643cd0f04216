// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>

#include "catch.h"
#include "sbox-bench/annotated_pairs.h"
#include "test_folder.h"

using namespace sbox::bench;

namespace {

std::string readError(const TestFolder& folder) {
  try {
    static_cast<void>(readPairFolder(folder.path()));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a pair is read with its truth", "[bench][annotated_pairs]") {
  const TestFolder folder("read");
  folder.write("pairs.json", R"({"resolution": 0.1, "pairs": [
    {"env": "office", "a": "one", "b": "sub/two", "theta_deg": 30, "theta_local": 29,
     "t_cells": [4, -5], "rms_cells": 1.5, "tol_cells": 7, "pa": [[1, 2], [3, 4]],
     "pb": [[5, 6], [7, 8]], "whatever": true},
    {"env": "far", "a": "one", "b": "three", "negative": true, "pa": [], "pb": []}]})");
  const PairFolder read = readPairFolder(folder.path());
  CHECK(read.resolution == 0.1);
  CHECK(read.name == "sbox_test_read");
  REQUIRE(read.pairs.size() == 2);
  const AnnotatedPair& pair = read.pairs[0];
  CHECK(pair.group == "office");
  CHECK(pair.b == "sub/two");
  CHECK(pair.theta_deg == 30);
  CHECK(pair.theta_local == 29.0);
  CHECK(pair.offset.y == -5);
  CHECK(pair.points_a[1].x == 3);
  CHECK(pair.points_b[1].y == 8);
  CHECK(pair.floor_cells == 1.5);
  CHECK(pair.tolerance_cells == 7);
  CHECK_FALSE(pair.negative);
  CHECK(read.pairs[1].negative);
}

TEST_CASE("what is written is read again", "[bench][annotated_pairs]") {
  const TestFolder folder("write");
  AnnotatedPair pair;
  pair.group = "office";
  pair.a = "one";
  pair.b = "two";
  pair.theta_deg = -30.5;
  pair.theta_local = -29;
  pair.offset = {4.25, -5};
  pair.points_a = {{1, 2}, {3, 4}};
  pair.points_b = {{5, 6}, {7, 8.5}};
  pair.floor_cells = 1.5;
  pair.tolerance_cells = 7;
  AnnotatedPair negative;
  negative.group = "far";
  negative.a = "one";
  negative.b = "three";
  negative.negative = true;
  writePairFolder({folder.path(), "", 0.1, {pair, negative}});
  const PairFolder read = readPairFolder(folder.path());
  CHECK(read.resolution == 0.1);
  REQUIRE(read.pairs.size() == 2);
  CHECK(read.pairs[0].group == pair.group);
  CHECK(read.pairs[0].b == pair.b);
  CHECK(read.pairs[0].theta_deg == pair.theta_deg);
  CHECK(read.pairs[0].theta_local == pair.theta_local);
  CHECK(read.pairs[0].offset == pair.offset);
  CHECK(read.pairs[0].points_a == pair.points_a);
  CHECK(read.pairs[0].points_b == pair.points_b);
  CHECK(read.pairs[0].floor_cells == pair.floor_cells);
  CHECK(read.pairs[0].tolerance_cells == pair.tolerance_cells);
  CHECK(read.pairs[1].negative);
  CHECK(read.pairs[1].b == negative.b);
  CHECK_THROWS_AS(writePairFolder({folder.path("missing"), "", 0.1, {}}), std::runtime_error);
}

TEST_CASE("a folder name with a slash at its end is the same", "[bench][annotated_pairs]") {
  const TestFolder folder("slash");
  folder.write("pairs.json", R"({"resolution": 0.05, "pairs": []})");
  CHECK(readPairFolder(folder.path() + "/").name == "sbox_test_slash");
}

TEST_CASE("a bad pairs.json is named with its fault", "[bench][annotated_pairs]") {
  const TestFolder folder("bad");
  CHECK(readError(folder).find("pairs.json: cannot be read") != std::string::npos);
  for (const char* text :
       {"", "{", "[]", R"({"pairs": []})", R"({"resolution": 0, "pairs": []})",
        R"({"resolution": 0.05, "pairs": [{"env": "e", "a": "1"}]})",
        R"({"resolution": 0.05, "pairs": [{"env": "e", "a": "1", "b": "2", "theta_deg": 0,
            "t_cells": [0, 0], "rms_cells": 0, "pa": [[1, 2]], "pb": []}]})",
        R"({"resolution": 0.05, "pairs": [{"env": "e", "a": "1", "b": "2", "theta_deg": 0,
            "t_cells": [0], "rms_cells": 0, "pa": [[1, 2]], "pb": [[1, 2]]}]})"}) {
    folder.write("pairs.json", text);
    INFO(text);
    CHECK(readError(folder).find(folder.path("pairs.json") + ": ") == 0);
  }
}

TEST_CASE("a map is looked for here, then in the parent, best format first",
          "[bench][annotated_pairs]") {
  const TestFolder folder("find");
  folder.write("set/here.png", "");
  folder.write("set/here.yaml", "");
  folder.write("set/near.gridmap.gz", "");
  folder.write("set/near.yaml", "");
  folder.write("near.gridmap", "");
  folder.write("other/far.gridmap", "");
  const std::string set = folder.path("set");
  CHECK(findMapFile(set, "here") == folder.path("set/here.yaml"));
  CHECK(findMapFile(set, "near") == folder.path("set/near.gridmap.gz"));
  CHECK(findMapFile(set, "other/far") == folder.path("other/far.gridmap"));
  CHECK_THROWS_AS(findMapFile(set, "missing"), std::runtime_error);
}
