// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/text_lines.h"

#include <fstream>
#include <sstream>

namespace sbox::dataset {

std::vector<TextLine> readTextLines(const std::string& path) {
  std::ifstream file(path);
  if (!file) {
    throw std::runtime_error(path + ": cannot be read");
  }
  std::vector<TextLine> lines;
  std::string text;
  for (int number = 1; std::getline(file, text); ++number) {
    std::istringstream words(text.substr(0, text.find('#')));
    TextLine line;
    line.place = path + ":" + std::to_string(number);
    if (!(words >> line.keyword)) {
      continue;
    }
    for (double value = 0; words >> value;) {
      line.numbers.push_back(value);
    }
    if (!words.eof()) {
      throw std::runtime_error(line.place + ": not a number");
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace sbox::dataset
