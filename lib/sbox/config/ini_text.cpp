// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/config/ini_text.h"

#include <set>
#include <sstream>
#include <utility>

#include "sbox/core/lower_case.h"

namespace sbox {
namespace {

std::string trimmed(const std::string& text) {
  const char* white_space = " \t\r\f\v";
  const size_t first = text.find_first_not_of(white_space);
  return first == std::string::npos
             ? ""
             : text.substr(first, text.find_last_not_of(white_space) - first + 1);
}

/// A comment starts a line or follows a blank, so that values may hold its characters.
std::string withoutComment(const std::string& line) {
  for (size_t i = 0; i < line.size(); ++i) {
    const bool starts = i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t';
    if (starts && (line[i] == ';' || line[i] == '#' || line.compare(i, 2, "//") == 0)) {
      return line.substr(0, i);
    }
  }
  return line;
}

}  // namespace

IniError::IniError(int line, const std::string& reason)
    : std::runtime_error("line " + std::to_string(line) + ": " + reason) {}

std::vector<IniEntry> parseIni(const std::string& text) {
  std::vector<IniEntry> entries;
  std::set<std::pair<std::string, std::string>> known;
  std::istringstream lines(text);
  std::string section, raw;
  for (int number = 1; std::getline(lines, raw); ++number) {
    const std::string line = trimmed(withoutComment(raw));
    if (line.empty()) {
      continue;
    }
    if (line.front() == '[' && line.back() == ']') {
      section = lowerCase(trimmed(line.substr(1, line.size() - 2)));
      continue;
    }
    const size_t equals = line.find('=');
    if (equals == std::string::npos) {
      throw IniError(number, "expected [section] or key = value");
    }
    IniEntry entry{section, lowerCase(trimmed(line.substr(0, equals))),
                   trimmed(line.substr(equals + 1)), number};
    if (section.empty()) {
      throw IniError(number, entry.key + " stands before any [section]");
    }
    if (!known.emplace(entry.section, entry.key).second) {
      throw IniError(number, "[" + section + "] " + entry.key + " is given twice");
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace sbox
