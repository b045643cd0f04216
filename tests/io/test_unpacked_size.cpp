// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CFileGZOutputStream.h>

#include <string>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox/io/unpacked_size.h"

using namespace sbox;

TEST_CASE("a file's size is what comes out of it, compressed or not", "[unpacked_size]") {
  const ScratchFolder folder;
  const std::string text(3'000'001, 'a');
  CHECK(unpackedSize(folder.write("plain", text)) == text.size());
  CHECK(unpackedSize(folder.write("empty", "")) == 0);
  CHECK(unpackedSize(folder.path("missing")) == 0);
  const std::string path = folder.path("compressed");
  {
    mrpt::io::CFileGZOutputStream out;
    REQUIRE(out.open(path));
    out.Write(text.data(), text.size());
  }
  const std::string compressed = folder.read("compressed");
  CHECK(compressed.size() < text.size() / 100);
  CHECK(unpackedSize(path) == text.size());
  // Up to where it is cut off.
  const std::string half = folder.write("half", compressed.substr(0, compressed.size() / 2));
  CHECK(unpackedSize(half) > text.size() / 10);
  CHECK(unpackedSize(half) < text.size());
}
