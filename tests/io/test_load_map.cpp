// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox/io/file_error.h"
#include "sbox/io/load_map.h"
#include "sbox/io/save_map.h"

using namespace sbox;

TEST_CASE("a file that is no map is refused in one line that names it", "[load_map]") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("folder.yaml"));
  folder.write("notes.txt", "hello");
  folder.write("empty.gridmap", "");
  folder.write("archive.gz", "hello");
  const auto [name, reason] = GENERATE(table<std::string, std::string>({
      {"missing.gridmap", "no such file"},
      {"missing.txt", "no such file"},
      {"missing/a.yaml", "no such file"},
      {"folder.yaml", "is a folder, not a file"},
      {"empty.gridmap", "is empty"},
      {"notes.txt",
       "is no map by its name: .gridmap[.gz], .simplemap[.gz], .yaml or an image (.png, .pgm, "
       ".bmp, .jpg, .tif) can be read"},
      {"archive.gz",
       "is no map by its name: .gridmap[.gz], .simplemap[.gz], .yaml or an image (.png, .pgm, "
       ".bmp, .jpg, .tif) can be read"},
  }));
  CHECK_THROWS_WITH(loadMap(folder.path(name)), folder.path(name) + ": " + reason);
}

TEST_CASE("an error is one line whatever the name", "[load_map]") {
  try {
    static_cast<void>(loadMap("missing\nfile\x1b.gridmap"));
    FAIL("was read");
  } catch (const FileError& error) {
    CHECK(std::string(error.what()) == "missing?file?.gridmap: no such file");
    CHECK(error.path() == "missing\nfile\x1b.gridmap");
  }
}

TEST_CASE("a device is not read", "[load_map]") {
  const ScratchFolder folder;
  std::filesystem::create_symlink("/dev/zero", folder.path("a.gridmap"));
  CHECK_THROWS_AS(loadMap(folder.path("a.gridmap")), FileError);
}

TEST_CASE("the image of a .yaml is read with it", "[load_map]") {
  const ScratchFolder folder;
  const std::string yaml = folder.path("m.yaml");
  saveMap(makeMap("m", 20, 10, 0.05), yaml);
  CHECK(filesRead(yaml) == std::vector<std::string>{yaml, folder.path("m.pgm")});
  CHECK(filesRead("none.yaml") == std::vector<std::string>{"none.yaml"});
  CHECK(filesRead("m.gridmap") == std::vector<std::string>{"m.gridmap"});
}
