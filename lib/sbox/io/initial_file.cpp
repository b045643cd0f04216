// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/initial_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>

#include "sbox/core/number_text.h"
#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"

namespace sbox {
namespace {

constexpr std::uint64_t kMostInitialBytes = 1 << 24;
constexpr const char* kBlank = " \t\r";

/// The last word, which is cut off the line.
std::string takeLastWord(std::string& line) {
  line.erase(line.find_last_not_of(kBlank) + 1);
  const size_t start = line.find_last_of(kBlank) + 1;
  std::string word = line.substr(start);
  line.erase(start);
  return word;
}

std::string spelling(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

/// The input that a name means.
int mapNamed(const std::string& given_name, const std::vector<std::string>& given_names) {
  const std::string name = spelling(given_name);
  std::vector<std::string> names(given_names.size());
  std::transform(given_names.begin(), given_names.end(), names.begin(), spelling);
  const auto exact = std::find(names.begin(), names.end(), name);
  if (exact != names.end()) {
    if (std::count(exact, names.end(), name) > 1) {
      throw std::string("is more than one of the maps");
    }
    return static_cast<int>(exact - names.begin());
  }
  std::optional<int> found;
  for (size_t i = 0; i < names.size(); ++i) {
    const std::string ending = "/" + name;
    if (names[i].size() > ending.size() &&
        names[i].compare(names[i].size() - ending.size(), ending.size(), ending) == 0) {
      if (found) {
        throw std::string("may be more than one of the maps");
      }
      found = static_cast<int>(i);
    }
  }
  if (!found) {
    throw std::string("is none of the maps");
  }
  return *found;
}

/// Throws what is wrong with the line as text.
InitialGuess guessOf(std::string line, const std::vector<std::string>& names) {
  std::array<double, 5> numbers{};
  for (size_t i = numbers.size(); i-- > 0;) {
    const std::optional<double> number = parseNumber(takeLastWord(line));
    if (!number) {
      throw std::string("must be FILE x y phi sigma_xy sigma_phi, in metres and degrees");
    }
    numbers[i] = *number;
  }
  line.erase(line.find_last_not_of(kBlank) + 1);
  const std::string name = line.substr(std::min(line.size(), line.find_first_not_of(kBlank)));
  constexpr double most_metres = 1e6;
  if (std::abs(numbers[0]) > most_metres || std::abs(numbers[1]) > most_metres) {
    throw std::string("has a pose beyond a thousand kilometres");
  }
  if (!(numbers[3] > 0 && numbers[4] > 0)) {
    throw std::string("must have uncertainties above zero");
  }
  InitialGuess guess;
  try {
    guess.map = mapNamed(name, names);
  } catch (const std::string& reason) {
    throw "\"" + name + "\" " + reason;
  }
  guess.pose = {numbers[0], numbers[1], wrapAngle(numbers[2] * M_PI / 180)};
  guess.sigma_xy = numbers[3];
  guess.sigma_phi = numbers[4] * M_PI / 180;
  return guess;
}

}  // namespace

std::vector<InitialGuess> loadInitialGuesses(const std::string& path,
                                             const std::vector<std::string>& names) {
  const Bytes bytes = readFile(path, kMostInitialBytes);
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::vector<InitialGuess> guesses;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const size_t start = line.find_first_not_of(kBlank);
    if (start == std::string::npos || line[start] == '#') {
      continue;
    }
    try {
      guesses.push_back(guessOf(line, names));
      const int map = guesses.back().map;
      if (std::any_of(guesses.begin(), guesses.end() - 1,
                      [&](const InitialGuess& known) { return known.map == map; })) {
        throw std::string("is the second of one map");
      }
    } catch (const std::string& reason) {
      throw FileError(path, "line " + std::to_string(number) + " " + reason);
    }
  }
  return guesses;
}

}  // namespace sbox
