// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a file of --initial: rough poses that can be reckoned with, or a FileError.
#include <cmath>

#include "fuzz/input_folder.h"
#include "sbox/io/file_error.h"
#include "sbox/io/initial_file.h"

using namespace sbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFolder folder;
  const std::vector<std::string> names{"one.yaml", "maps/two maps.yaml", "maps/three"};
  std::vector<InitialGuess> guesses;
  try {
    guesses = loadInitialGuesses(folder.write("in.txt", {data, data + size}), names);
  } catch (const FileError&) {
    return 0;
  }
  fuzz::require(guesses.size() <= names.size());
  for (const InitialGuess& guess : guesses) {
    fuzz::require(guess.map >= 0 && static_cast<std::size_t>(guess.map) < names.size());
    fuzz::require(std::isfinite(guess.pose.x) && std::isfinite(guess.pose.y) &&
                  std::isfinite(guess.pose.phi));
    fuzz::require(guess.sigma_xy > 0 && guess.sigma_phi > 0);
  }
  return 0;
}
