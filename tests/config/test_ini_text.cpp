// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/config/ini_text.h"

using namespace sbox;

TEST_CASE("sections, keys and values are read with their lines") {
  const std::vector<IniEntry> entries = parseIni(
      "; a comment\n\n[First]\n  Key = a value  // why\r\nother=1;2\n# more\n[second]\nkey=\n");
  REQUIRE(entries.size() == 3);
  CHECK(entries[0].section == "first");
  CHECK(entries[0].key == "key");
  CHECK(entries[0].value == "a value");
  CHECK(entries[0].line == 4);
  CHECK(entries[1].value == "1;2");
  CHECK(entries[2].section == "second");
  CHECK(entries[2].value.empty());
}

TEST_CASE("what is neither section nor key is an error with its line") {
  const auto message = [](const std::string& text) -> std::string {
    try {
      (void)parseIni(text);
    } catch (const IniError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message("[a]\nkey\n") == "line 2: expected [section] or key = value");
  CHECK(message("[a\n") == "line 1: expected [section] or key = value");
  CHECK(message("key = 1\n") == "line 1: key stands before any [section]");
  CHECK(message("[a]\nkey = 1\n[b]\nkey = 1\n[A]\nKEY = 2\n") == "line 6: [a] key is given twice");
  CHECK(message("").empty());
}
