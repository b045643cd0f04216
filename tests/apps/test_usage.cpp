// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Wrong usage and unusable files: exit codes 2 and 1, one line on stderr, nothing written.
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "apps/check_contains.h"
#include "apps/command.h"
#include "apps/office.h"
#include "catch.h"
#include "sbox/io/save_map.h"

using namespace sbox;
using namespace sbox::test;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

namespace {

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// The command must fail so and leave the folder as it is.
void checkFailure(const ScratchFolder& folder, const Words& arguments, int exit_code,
                  const std::string& message) {
  std::string call;
  for (const std::string& argument : arguments) {
    call += " " + argument;
  }
  INFO("sbox-merge" << call);
  const Words before = listing(folder.path());
  const Outcome outcome = runMerge(folder.path(), arguments);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.out.empty());
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(outcome.err.rfind("sbox-merge: ", 0) == 0);
  checkContains(outcome.err, message);
  CHECK(listing(folder.path()) == before);
}

}  // namespace

TEST_CASE("help and version go to stdout") {
  const ScratchFolder folder;
  const Outcome help = runMerge(folder.path(), {"--help"});
  CHECK(help.exit_code == 0);
  CHECK(help.err.empty());
  for (const char* option :
       {"--in",    "--out",     "--report",    "--pictures",   "--html",   "--tf",
        "--graph", "--initial", "--reference", "--all-groups", "--method", "--fusion",
        "--bend",  "--config",  "--threads",   "--resolution", "--pairs",  "--join",
        "--quiet", "--verbose", "--version"}) {
    checkContains(help.out, option);
  }
  const Outcome version = runMerge(folder.path(), {"--version"});
  CHECK(version.exit_code == 0);
  checkContains(version.out, "sbox-merge " SBOX_VERSION);
}

TEST_CASE("wrong usage ends in 2 and says what is wrong") {
  const ScratchFolder folder;
  saveMap(office("a", 1), folder / "a.gridmap");
  checkFailure(folder, {}, 2, "--in needs two maps or more");
  checkFailure(folder, {"--in", "a.gridmap"}, 2, "--in needs two maps or more");
  checkFailure(folder, {"--in"}, 2, "--in");
  checkFailure(folder, {"--frobnicate"}, 2, "--frobnicate");
  const auto with = beginningWith({"--in", "a.gridmap", "a.gridmap"});
  checkFailure(folder, with({"--reference", "2"}), 2, "--reference must be from 0 to 1, not 2");
  checkFailure(folder, with({"--reference", "-1"}), 2, "--reference");
  checkFailure(folder, with({"--reference", "x"}), 2, "--reference");
  checkFailure(folder, with({"--threads", "-1"}), 2, "--threads must be from 0 to 1024, not -1");
  checkFailure(folder, with({"--method", "guess"}), 2, "--method must be");
  checkFailure(folder, with({"--fusion", "max"}), 2,
               "--fusion must be logodds or observations or table, not max");
  checkFailure(folder, with({"--out", "m.jpg"}), 2, "--out must end in");
  checkFailure(folder, with({"--resolution", "0"}), 2, "--resolution must be");
  checkFailure(folder, with({"--resolution", "nan"}), 2, "--resolution must be");
  checkFailure(folder, with({"--resolution", "500"}), 2,
               "--resolution must be from 0.001 to 100 metres, not 500");
  for (const char* share : {"0/2", "3/2", "1", "1/2x", "-1/2", "1/99999999"}) {
    checkFailure(folder, with({"--pairs", share, "--report", "r.json"}), 2,
                 "--pairs must be K/N with K from 1 to N, not " + std::string(share));
  }
  checkFailure(folder, with({"--pairs", "1/3", "--report", "r.json"}), 2,
               "--pairs takes no more shares than maps, 2, not 3");
  for (const char* option : {"--pairs", "--join", "--report", "--initial", "--method"}) {
    checkFailure(folder, with({option, ""}), 2, std::string(option) + " has an empty value");
  }
  checkFailure(folder, {"--in", "a.gridmap", "b.rawlog", "--pairs", "1/2", "--report", "r.json"}, 2,
               "--pairs takes maps, not logs: map b.rawlog first, then give its .simplemap");
  checkFailure(folder, with({"--pairs", "1/2"}), 2, "--pairs needs a --report to write to");
  checkFailure(folder, with({"--pairs", "1/2", "--report", "r.json", "--out", "m.yaml"}), 2,
               "--pairs merges nothing, so that there is no m.yaml to write");
  checkFailure(folder, with({"--pairs", "1/2", "--report", "r.json", "--html", "p.html"}), 2,
               "--pairs merges nothing, so that there is no p.html to write");
  checkFailure(folder, with({"--pairs", "1/2", "--report", "r.json", "--join", "a.json"}), 2,
               "--pairs and --join exclude each other");
}

TEST_CASE("a map that cannot be used ends in 1 and is named") {
  const ScratchFolder folder;
  saveMap(office("a", 1), folder / "a.gridmap");
  const auto with = [](const std::string& name) { return Words{"--in", "a.gridmap", name}; };
  checkFailure(folder, with("missing.gridmap"), 1, "missing.gridmap: ");
  write(folder / "empty.gridmap", "");
  checkFailure(folder, with("empty.gridmap"), 1, "empty.gridmap: ");
  const std::string whole = contents(folder / "a.gridmap");
  write(folder / "half.gridmap", whole.substr(0, whole.size() / 2));
  checkFailure(folder, with("half.gridmap"), 1, "half.gridmap: ");
  write(folder / "noise.yaml", "\x01\xff{[: noise");
  checkFailure(folder, with("noise.yaml"), 1, "noise.yaml: ");
  write(folder / "map.xyz", "?");
  checkFailure(folder, with("map.xyz"), 1, "map.xyz: ");
  fs::create_directory(folder / "folder.gridmap");
  checkFailure(folder, with("folder.gridmap"), 1, "folder.gridmap: ");
  saveMap(makeMap("blank", 30, 30, 0.05), folder / "blank.gridmap");
  checkFailure(folder, with("blank.gridmap"), 1, "blank.gridmap: has no occupied cell");
  Map dot = makeMap("dot", 1, 1, 0.05);
  dot.grid.setCell(0, 0, 0);
  saveMap(dot, folder / "dot.gridmap");
  checkFailure(folder, with("dot.gridmap"), 1, "dot.gridmap: is too small to match");
  saveMap(office("a", 1), folder / "plain.png");
  checkFailure(folder, with("plain.png"), 1, "plain.png: ");
}

TEST_CASE("shares that cannot be joined end in 1 and are named") {
  const ScratchFolder folder;
  saveMap(office("a", 1), folder / "a.gridmap");
  const auto with = beginningWith({"--in", "a.gridmap", "a.gridmap"});
  const Words share = with({"--pairs", "1/2", "--report", "one.json", "-q"});
  REQUIRE(runMerge(folder.path(), share).exit_code == 0);
  checkFailure(folder, with({"--join", "none.json"}), 1, "none.json: ");
  write(folder / "half.json", contents(folder / "one.json").substr(0, 200));
  checkFailure(folder, with({"--join", "half.json"}), 1,
               "half.json: is not what --pairs writes, or is damaged: make it anew");
  checkFailure(folder, with({"--join", "one.json"}), 1,
               "one.json: is of 2 shares, but share 2 is missing");
  checkFailure(folder, with({"--join", "one.json", "one.json"}), 1,
               "one.json: holds share 1/2, which another file holds, too");
}

TEST_CASE("an output that cannot be written ends in 1 and leaves the others unwritten") {
  const ScratchFolder folder;
  saveMap(office("a", 1), folder / "a.gridmap");
  const auto with = beginningWith({"--in", "a.gridmap", "a.gridmap"});
  checkFailure(folder, with({"--out", "nowhere/m.gridmap"}), 1, "nowhere/m.gridmap: ");
  checkFailure(folder, with({"--report", "nowhere/r.json"}), 1, "nowhere/r.json: ");
  checkFailure(folder, with({"--pictures", "a.gridmap"}), 1, "a.gridmap: ");
  checkFailure(folder, with({"--pictures", "a.gridmap/sub"}), 1, "a.gridmap/sub: ");
  checkFailure(folder, with({"--report", "merged.gridmap"}), 1, "merged.gridmap: ");
  fs::create_directory(folder / "merged.png");
  checkFailure(folder, with({}), 1, "merged.png: ");
  // Outputs are looked at first, the image of a .yaml among them.
  fs::create_directory(folder / "m.pgm");
  checkFailure(folder, {"--in", "a.gridmap", "none.gridmap", "--out", "m.yaml"}, 1, "m.pgm: ");
}

TEST_CASE("an output in the place of what is read ends in 1") {
  const ScratchFolder folder;
  saveMap(office("a", 1), folder / "a.yaml");  // With a.pgm.
  saveMap(office("a", 1), folder / "b.gridmap");
  write(folder / "c.ini", "[fusion]\n");
  const auto with = beginningWith({"--in", "a.yaml", "./b.gridmap"});
  checkFailure(folder, with({"--out", "b.gridmap"}), 1, "b.gridmap: is an input");
  checkFailure(folder, with({"--out", "a.gridmap", "--report", "a.pgm"}), 1,
               "a.pgm: is the image of the input a.yaml");
  checkFailure(folder, with({"--report", "../" + folder.path().filename().string() + "/a.yaml"}), 1,
               "a.yaml: is an input");
  checkFailure(folder, with({"--config", "c.ini", "--tf", "c.ini"}), 1,
               "c.ini: is a file of settings");
}

TEST_CASE("a folder without the right to write ends in 1") {
  if (geteuid() == 0) {
    WARN("skipped: root may write everywhere");
    return;
  }
  const ScratchFolder folder;
  saveMap(office("a", 1), folder / "a.gridmap");
  fs::create_directory(folder / "locked");
  fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  checkFailure(folder, {"--in", "a.gridmap", "a.gridmap", "--out", "locked/m.gridmap"}, 1,
               "locked/m.gridmap: ");
}

TEST_CASE("a configuration that cannot be used ends in 1 and names file, line and key") {
  const ScratchFolder folder;
  saveMap(office("a", 1), folder / "a.gridmap");
  const Words call{"--in", "a.gridmap", "a.gridmap", "--config", "c.ini"};
  checkFailure(folder, call, 1, "c.ini: ");
  write(folder / "c.ini", "[fusion]\nrool = table\n");
  checkFailure(folder, call, 1, "c.ini: line 2: there is no option [fusion] rool");
  write(folder / "c.ini", "[fussion]\nrule = table\n");
  checkFailure(folder, call, 1, "c.ini: line 2: there is no section [fussion]");
  write(folder / "c.ini", "[paper.lines]\nrho_step = 0\n");
  checkFailure(folder, call, 1, "c.ini: line 2: [paper.lines] rho_step must be a number from");
  write(folder / "c.ini", std::string(2 << 20, '#'));
  checkFailure(folder, call, 1, "c.ini: ");
}
