// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <stdexcept>

#include "catch.h"
#include "sbox/io/flat_yaml.h"

using namespace sbox;

namespace {

using Items = std::vector<std::string>;
using Kind = FlatYamlValue::Kind;

std::string scalar(const std::string& text) {
  const auto values = parseFlatYaml("key: " + text);
  REQUIRE(values.at("key").kind == Kind::Scalar);
  return values.at("key").items.at(0);
}

Items list(const std::string& text) {
  const auto values = parseFlatYaml(text);
  REQUIRE(values.at("key").kind == Kind::List);
  return values.at("key").items;
}

}  // namespace

TEST_CASE("plain scalars end before a comment", "[flat_yaml]") {
  CHECK(scalar("a.pgm") == "a.pgm");
  CHECK(scalar("  my map#2.pgm  # the best") == "my map#2.pgm");
  CHECK(scalar("C:/maps/a.pgm") == "C:/maps/a.pgm");
  CHECK(scalar("-0.5") == "-0.5");
  CHECK(scalar("a]b, c") == "a]b, c");
}

TEST_CASE("quoted scalars keep what plain ones cannot hold", "[flat_yaml]") {
  CHECK(scalar("'it''s # [a] map: 1'  # one") == "it's # [a] map: 1");
  CHECK(scalar(R"("a \"b\" \\ c")") == R"(a "b" \ c)");
  CHECK(scalar("''").empty());
  CHECK_THROWS_AS(scalar("'open"), std::invalid_argument);
  CHECK_THROWS_AS(scalar(R"("open\")"), std::invalid_argument);
  CHECK_THROWS_AS(scalar("'a' b"), std::invalid_argument);
}

TEST_CASE("a written scalar reads back", "[flat_yaml]") {
  const std::string text = GENERATE("a.pgm", "with space", "q\"uo'te", "back\\slash", "#", "", "-",
                                    "a: b", "[1]", "\xC3\xA4.pgm", "true");
  CHECK(scalar(yamlScalar(text)) == text);
  CHECK(yamlScalar("maps/merged-1.pgm") == "maps/merged-1.pgm");
}

TEST_CASE("lists stand in brackets or one item a line", "[flat_yaml]") {
  CHECK(list("key: [1, -2.5,'x, y']  # c") == Items{"1", "-2.5", "x, y"});
  CHECK(list("key: []").empty());
  CHECK(list("key: [ 1,\n  2,  # two\n3 ]\nnext: 4") == Items{"1", "2", "3"});
  CHECK(list("key:\n  - 1\n  - 2  # two\n  -   '3'\n") == Items{"1", "2", "3"});
  CHECK(list("key:\n- 1\n\n# between\n- 2\nnext: 3") == Items{"1", "2"});
  CHECK_THROWS_AS(list("key: [1, 2"), std::invalid_argument);
  CHECK_THROWS_AS(list("key: [1, 2] 3"), std::invalid_argument);
  CHECK_THROWS_AS(list("key: ['1' '2']"), std::invalid_argument);
}

TEST_CASE("what frames a document is skipped", "[flat_yaml]") {
  const std::string text =
      "\xEF\xBB\xBF%YAML 1.2\n---\n# a map\n\nkey: 1\r\nother: 2\r\n...\nnot: read\n";
  const auto values = parseFlatYaml(text);
  CHECK(values.size() == 2);
  CHECK(values.at("key").items == Items{"1"});
  CHECK(values.at("other").items == Items{"2"});
  CHECK(parseFlatYaml("a: 1\n---\na: 2\n").at("a").items == Items{"1"});
  CHECK(parseFlatYaml("\n# nothing\n").empty());
}

TEST_CASE("values of other kinds are skipped but known", "[flat_yaml]") {
  const auto values = parseFlatYaml(
      "nested:\n  inner: 1\n  deep:\n    - 2\nflow: {a: 1}\nanchor: &x 1\nblock: |\n  text\n"
      "folded: one\n  two\nkey: 1\n");
  for (const char* key : {"nested", "flow", "anchor", "block", "folded"}) {
    CHECK(values.at(key).kind == Kind::Other);
  }
  CHECK(values.at("key").items == Items{"1"});
}

TEST_CASE("what is no mapping is refused, saying where", "[flat_yaml]") {
  CHECK_THROWS_WITH(parseFlatYaml("a: 1\nhello\n"), "line 2 has no \"key: value\"");
  for (const std::string text :
       {"- a\n- b", "hello", "a:1", "  a: 1", "{a: 1}", ": 1", "a: 1\na: 2", "[1, 2]", "'a: 1"}) {
    CHECK_THROWS_AS(parseFlatYaml(text), std::invalid_argument);
  }
  CHECK_THROWS_AS(parseFlatYaml(std::string("a: 1\0", 5)), std::invalid_argument);
}

TEST_CASE("random text is read or refused", "[flat_yaml]") {
  std::mt19937 random(7);
  const std::string letters = "ab :-[],'\"#\n\t\\{}&12";
  for (int round = 0; round < 2000; ++round) {
    std::string text;
    for (auto left = random() % 60; left > 0; --left) {
      text.push_back(letters[random() % letters.size()]);
    }
    try {
      for (const auto& [key, value] : parseFlatYaml(text)) {
        CHECK((value.kind != Kind::Scalar || value.items.size() <= 1));
      }
    } catch (const std::invalid_argument&) {
    }
  }
  CHECK_THROWS_AS(parseFlatYaml(std::string(100000, '[')), std::invalid_argument);
}
