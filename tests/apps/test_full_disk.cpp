// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Outputs that cannot be written to their end. A limit on the size of files stands in for a full
// disk: the write fails in the same way.
#include <algorithm>
#include <fstream>

#include "apps/check_contains.h"
#include "apps/command.h"
#include "apps/office.h"
#include "catch.h"
#include "sbox/io/save_map.h"

using namespace sbox;
using namespace sbox::test;
using Words = std::vector<std::string>;

TEST_CASE("an output that does not fit ends in 1 and leaves everything as it was") {
  const ScratchFolder folder;
  const Map floor = office("floor", 1);
  saveMap(cutColumns(floor, "a", 0, 400, {}), (folder / "a.yaml").string());
  saveMap(cutColumns(floor, "b", 60, 480, {}), (folder / "b.yaml").string());
  // In blocks of 512 bytes. Which file fails first depends on the limit.
  const auto [blocks, option, file] = GENERATE(table<int, std::string, std::string>({
      {0, "merged.gridmap", "merged.gridmap"},
      {4, "merged.gridmap", "merged.gridmap"},
      {1, "merged.yaml", "merged.pgm"},
      {100, "merged.gridmap", "r.html"},
  }));
  std::ofstream(folder / file) << "precious";
  const Words before = listing(folder.path());
  const Outcome outcome = runMerge(
      folder.path(),
      {"--in", "a.yaml", "b.yaml", "--out", option, "--html", "r.html", "--pictures", "new/folder"},
      "ulimit -f " + std::to_string(blocks));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.empty());
  CHECK(listing(folder.path()) == before);
  CHECK(contents(folder / file) == "precious");
}
