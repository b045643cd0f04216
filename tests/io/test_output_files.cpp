// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/stat.h>
#include <unistd.h>

#include <stdexcept>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox/io/file_error.h"
#include "sbox/io/output_files.h"

using namespace sbox;

namespace {

void put(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("staged files appear on commit and not before", "[output_files]") {
  const ScratchFolder folder;
  folder.write("b.txt", "old");
  OutputFiles files;
  put(files.stage(folder.path("a.gridmap.gz")), "new a");
  put(files.stage(folder.path("b.txt")), "new b");
  CHECK(folder.read("b.txt") == "old");
  CHECK_FALSE(std::filesystem::exists(folder.path("a.gridmap.gz")));
  files.commit();
  CHECK(folder.names() == Names{"a.gridmap.gz", "b.txt"});
  CHECK(folder.read("a.gridmap.gz") == "new a");
  CHECK(folder.read("b.txt") == "new b");
}

TEST_CASE("nothing stays of what was not committed", "[output_files]") {
  const ScratchFolder folder;
  folder.write("b.txt", "old");
  try {
    OutputFiles files;
    put(files.stage(folder.path("a.txt")), "new");
    put(files.stage(folder.path("b.txt")), "new");
    throw std::runtime_error("something failed");
  } catch (const std::runtime_error&) {
  }
  CHECK(folder.names() == Names{"b.txt"});
  CHECK(folder.read("b.txt") == "old");
}

TEST_CASE("a protected file is refused, whatever it is called") {
  const ScratchFolder folder;
  folder.write("a.txt", "old");
  std::filesystem::create_symlink("a.txt", folder.path("link.txt"));
  OutputFiles files;
  files.protect(folder.path("a.txt"), "is read");
  files.protect(folder.path("none.txt"), "is not there");
  for (const char* name : {"a.txt", "./a.txt", "link.txt"}) {
    std::string reason;
    try {
      files.stage(folder.path(name));
    } catch (const FileError& error) {
      reason = error.reason();
    }
    CHECK(reason == "is read");
  }
  CHECK_NOTHROW(files.stage(folder.path("none.txt")));
}

TEST_CASE("a temporary file keeps the extension of its target", "[output_files]") {
  const ScratchFolder folder;
  OutputFiles files;
  const std::string staged = files.stage(folder.path("a.gridmap.gz"));
  CHECK(staged.substr(staged.size() - 11) == ".gridmap.gz");
  CHECK(std::filesystem::path(staged).parent_path() ==
        std::filesystem::canonical(folder.path(".")));
}

TEST_CASE("two sets of outputs do not meet in one temporary file", "[output_files]") {
  const ScratchFolder folder;
  OutputFiles first, second;
  CHECK(first.stage(folder.path("a.txt")) != second.stage(folder.path("a.txt")));
}

TEST_CASE("a target that cannot be written is refused when it is staged", "[output_files]") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("folder"));
  mkfifo(folder.path("pipe").c_str(), 0600);
  std::filesystem::create_symlink("nowhere", folder.path("dangling"));
  OutputFiles files;
  for (const char* name : {"folder", "folder/", "missing/a.txt", "pipe", "dangling", ""}) {
    CHECK_THROWS_AS(files.stage(folder.path(name)), FileError);
  }
  CHECK_THROWS_AS(files.stage(""), FileError);
  CHECK_THROWS_AS(files.stage("/dev/full"), FileError);
  CHECK(folder.names() == Names{"dangling", "folder", "pipe"});
}

TEST_CASE("a file or a folder without the right to write is refused", "[output_files]") {
  if (geteuid() == 0) {
    WARN("skipped: root may write everywhere");
    return;
  }
  const ScratchFolder folder;
  folder.write("a.txt", "old");
  chmod(folder.path("a.txt").c_str(), 0400);
  std::filesystem::create_directory(folder.path("closed"));
  chmod(folder.path("closed").c_str(), 0500);
  OutputFiles files;
  CHECK_THROWS_AS(files.stage(folder.path("a.txt")), FileError);
  CHECK_THROWS_AS(files.stage(folder.path("closed/a.txt")), FileError);
}

TEST_CASE("two outputs may not have one target, however it is spelled", "[output_files]") {
  const ScratchFolder folder;
  OutputFiles files;
  files.stage(folder.path("a.txt"));
  CHECK_THROWS_AS(files.stage(folder.path("./a.txt")), FileError);
  files.stage(folder.path("b.txt"));
}

TEST_CASE("a link is followed, not replaced", "[output_files]") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("real"));
  folder.write("real/a.txt", "old");
  std::filesystem::create_symlink("real/a.txt", folder.path("a.txt"));
  OutputFiles files;
  put(files.stage(folder.path("a.txt")), "new");
  files.commit();
  CHECK(std::filesystem::is_symlink(folder.path("a.txt")));
  CHECK(folder.read("real/a.txt") == "new");
}

TEST_CASE("a target that became a folder keeps all others as they were", "[output_files]") {
  const ScratchFolder folder;
  folder.write("a.txt", "old");
  {
    OutputFiles files;
    put(files.stage(folder.path("a.txt")), "new");
    put(files.stage(folder.path("b.txt")), "new");
    std::filesystem::create_directory(folder.path("b.txt"));
    CHECK_THROWS_AS(files.commit(), FileError);
  }
  CHECK(folder.read("a.txt") == "old");
  CHECK(folder.names() == Names{"a.txt", "b.txt"});
}

TEST_CASE("a file that cannot be filled is named as the user knows it, and leaves nothing",
          "[output_files]") {
  const ScratchFolder folder;
  std::string told;
  {
    OutputFiles files;
    try {
      files.write(folder.path("b.png"), [](const std::string& temporary) {
        CHECK(std::filesystem::exists(temporary));
        throw FileError(temporary, "cannot be drawn");
      });
    } catch (const FileError& error) {
      told = error.what();
    }
  }
  CHECK(told == folder.path("b.png") + ": cannot be drawn");
  CHECK(folder.names().empty());
}
