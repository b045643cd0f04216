// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox/config/option_table.h"

using namespace sbox;

namespace {

enum class Colour { Red, Blue };

struct ToyOptions {
  double reach = 0.5;
  double turn = M_PI / 30;
  double share = 0.25;
  int most = 7;
  size_t points = 400;
  Colour colour = Colour::Blue;
};

OptionTable describe(ToyOptions& toy) {
  OptionTable table;
  table.section("lengths");
  table.metres("reach", toy.reach, {0.01, 10}, "How far");
  table.degrees("turn", toy.turn, {0, 180}, "How much");
  table.section("rest");
  table.number("share", toy.share, {0, 1}, "How often");
  table.count("most", toy.most, {1, 1000}, "How many");
  table.count("points", toy.points, {0, 1000000}, "Of how many");
  table.choice<Colour>("colour", toy.colour, {{"red", Colour::Red}, {"blue", Colour::Blue}},
                       "Which");
  return table;
}

std::string message(const std::string& ini) {
  ToyOptions toy;
  try {
    describe(toy).apply(parseIni(ini));
  } catch (const IniError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("options take the values of the file, and keep theirs where it is silent") {
  ToyOptions toy;
  describe(toy).apply(
      parseIni("[lengths]\nreach = 2.5\nturn = 90\n[REST]\nMost = 12\npoints=0\ncolour = red\n"));
  CHECK(toy.reach == 2.5);
  CHECK(toy.turn == Approx(M_PI / 2));
  CHECK(toy.share == 0.25);
  CHECK(toy.most == 12);
  CHECK(toy.points == 0);
  CHECK(toy.colour == Colour::Red);
}

TEST_CASE("what the table does not know, or out of range, is an error that names it") {
  CHECK(message("[length]\nreach = 1\n") == "line 2: there is no section [length]");
  CHECK(message("[lengths]\nraech = 1\n") == "line 2: there is no option [lengths] raech");
  CHECK(message("[rest]\nreach = 1\n") == "line 2: there is no option [rest] reach");
  CHECK(message("[lengths]\n\nreach = 11\n") ==
        "line 3: [lengths] reach must be a number from 0.01 to 10, not \"11\"");
  CHECK(message("[lengths]\nturn = nan\n") ==
        "line 2: [lengths] turn must be a number from 0 to 180, not \"nan\"");
  CHECK(message("[rest]\nmost = 1.5\n") ==
        "line 2: [rest] most must be a whole number from 1 to 1000, not \"1.5\"");
  CHECK(message("[rest]\npoints = -1\n") ==
        "line 2: [rest] points must be a whole number from 0 to 1000000, not \"-1\"");
  CHECK(message("[rest]\ncolour =\n") == "line 2: [rest] colour must be red or blue, not \"\"");
}

TEST_CASE("the dump reads back to the same values") {
  ToyOptions toy{1.25, 0.123, 1.0 / 3, 3, 1000000, Colour::Red};
  const std::string dump = describe(toy).dump();
  CHECK(dump.find("reach = 1.25 ") != std::string::npos);
  CHECK(dump.find("; How much, degrees, 0 to 180\n") != std::string::npos);
  ToyOptions again;
  describe(again).apply(parseIni(dump));
  CHECK(again.reach == toy.reach);
  CHECK(again.turn == Approx(toy.turn).epsilon(1e-11));
  CHECK(again.share == toy.share);
  CHECK(again.most == 3);
  CHECK(again.points == 1000000);
  CHECK(again.colour == Colour::Red);
  ToyOptions defaults;
  CHECK(describe(defaults).dump().find("turn = 6 ") != std::string::npos);
}
