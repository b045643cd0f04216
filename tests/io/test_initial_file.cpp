// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox/io/file_error.h"
#include "sbox/io/initial_file.h"

using namespace sbox;

namespace {

const std::vector<std::string> kNames{"maps/one.yaml", "maps/two maps.yaml", "other/one.yaml"};

std::vector<InitialGuess> load(const std::string& text) {
  const ScratchFolder folder;
  return loadInitialGuesses(folder.write("initial.txt", text), kNames);
}

std::string reasonAgainst(const std::string& text) {
  try {
    (void)load(text);
  } catch (const FileError& error) {
    return error.reason();
  }
  return "";
}

}  // namespace

TEST_CASE("rough poses are read from lines, angles in degrees") {
  const std::vector<InitialGuess> guesses =
      load("# drawn by hand\n\nmaps/one.yaml 1.5 -2 90 0.5 10\r\n  two maps.yaml 3 4 -180 1 5");
  REQUIRE(guesses.size() == 2);
  CHECK(guesses[0].map == 0);
  CHECK(guesses[0].pose.x == 1.5);
  CHECK(guesses[0].pose.y == -2);
  CHECK(guesses[0].pose.phi == Approx(M_PI / 2));
  CHECK(guesses[0].sigma_xy == 0.5);
  CHECK(guesses[0].sigma_phi == Approx(10 * M_PI / 180));
  CHECK(guesses[1].map == 1);
  CHECK(load("\n").empty());
  CHECK(load("./maps/../other/one.yaml 0 0 0 1 1").at(0).map == 2);
}

TEST_CASE("bad files of rough poses are refused with the line") {
  CHECK(reasonAgainst("\nmaps/one.yaml 1 2 3 4\n") ==
        "line 2 must be FILE x y phi sigma_xy sigma_phi, in metres and degrees");
  CHECK(reasonAgainst("maps/one.yaml 1 2 x 4 5\n") ==
        "line 1 must be FILE x y phi sigma_xy sigma_phi, in metres and degrees");
  CHECK(reasonAgainst("1 2 3 4 5") == "line 1 \"\" is none of the maps");
  CHECK(reasonAgainst("three.yaml 1 2 3 4 5") == "line 1 \"three.yaml\" is none of the maps");
  CHECK(reasonAgainst("one.yaml 1 2 3 4 5") ==
        "line 1 \"one.yaml\" may be more than one of the maps");
  CHECK(reasonAgainst("maps/one.yaml 1 2 3 0 5") == "line 1 must have uncertainties above zero");
  CHECK(reasonAgainst("maps/one.yaml 1e9 2 3 1 5") ==
        "line 1 has a pose beyond a thousand kilometres");
  CHECK(reasonAgainst("maps/one.yaml 1 2 3 4 5\nmaps/one.yaml 1 2 3 4 5") ==
        "line 2 is the second of one map");
  CHECK_THROWS_AS(loadInitialGuesses("missing.txt", kNames), FileError);
}
