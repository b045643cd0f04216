// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// In a build without SLAM the command takes no logs, and says so.
#include "apps/check_contains.h"
#include "apps/command.h"
#include "catch.h"

using namespace sbox::test;

TEST_CASE("without SLAM a log is refused by name") {
  const ScratchFolder folder;
  const Outcome outcome = runMerge(folder.path(), {"--in", "a.rawlog", "b.rawlog.gz"});
  CHECK(outcome.exit_code == 1);
  checkContains(outcome.err, "sbox-merge: a.rawlog: needs SLAM, and /");
  checkContains(outcome.err, "sbox-merge-with-slam cannot be run");
  CHECK(listing(folder.path()).empty());
}
