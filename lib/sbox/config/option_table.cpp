// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/config/option_table.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "sbox/core/number_text.h"

namespace sbox {
namespace {

std::string rangeText(Range range) {
  return numberText(range.low) + " to " + numberText(range.high);
}

/// Twelve digits: hides what 6 degrees lose on the way to radians and back.
double rounded(double value) {
  if (value == 0) {
    return 0;
  }
  const double unit = std::pow(10, 11 - std::floor(std::log10(std::abs(value))));
  return std::round(value * unit) / unit;
}

std::string wholeRangeText(Range range) {
  return std::to_string(static_cast<int>(range.low)) + " to " +
         std::to_string(static_cast<int>(range.high));
}

double parseInRange(const std::string& text, Range range, bool whole) {
  const std::optional<double> number = parseNumber(text);
  if (!number || *number < range.low || *number > range.high ||
      (whole && *number != std::floor(*number))) {
    throw std::invalid_argument(whole ? "must be a whole number from " + wholeRangeText(range)
                                      : "must be a number from " + rangeText(range));
  }
  return *number;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " or ") + word;
  }
  return text;
}

}  // namespace

void OptionTable::addNumber(const std::string& key, double& value, Range range, double file_unit,
                            const std::string& meaning) {
  rows_.push_back({section_, key, meaning + ", " + rangeText(range),
                   [&value, file_unit] {
                     return numberText(file_unit == 1 ? value : rounded(value / file_unit));
                   },
                   [&value, range, file_unit](const std::string& text) {
                     value = parseInRange(text, range, false) * file_unit;
                   }});
}

void OptionTable::metres(const std::string& key, double& value, Range range,
                         const std::string& meaning) {
  addNumber(key, value, range, 1, meaning + ", metres");
}

void OptionTable::degrees(const std::string& key, double& value, Range range,
                          const std::string& meaning) {
  addNumber(key, value, range, M_PI / 180, meaning + ", degrees");
}

void OptionTable::number(const std::string& key, double& value, Range range,
                         const std::string& meaning) {
  addNumber(key, value, range, 1, meaning);
}

template <typename Whole>
void OptionTable::addCount(const std::string& key, Whole& value, Range range,
                           const std::string& meaning) {
  rows_.push_back({section_, key, meaning + ", " + wholeRangeText(range),
                   [&value] { return std::to_string(value); },
                   [&value, range](const std::string& text) {
                     value = static_cast<Whole>(parseInRange(text, range, true));
                   }});
}

void OptionTable::count(const std::string& key, int& value, Range range,
                        const std::string& meaning) {
  addCount(key, value, range, meaning);
}

void OptionTable::count(const std::string& key, size_t& value, Range range,
                        const std::string& meaning) {
  addCount(key, value, range, meaning);
}

void OptionTable::addChoice(const std::string& key, const std::vector<std::string>& words,
                            const std::string& meaning, const std::function<size_t()>& read,
                            const std::function<void(size_t)>& write) {
  rows_.push_back({section_, key, meaning + ", " + joined(words),
                   [words, read] { return words.at(read()); },
                   [words, write](const std::string& text) {
                     const auto found = std::find(words.begin(), words.end(), text);
                     if (found == words.end()) {
                       throw std::invalid_argument("must be " + joined(words));
                     }
                     write(static_cast<size_t>(found - words.begin()));
                   }});
}

void OptionTable::set(const std::string& section, const std::string& key,
                      const std::string& value) const {
  const auto in_section = [&](const OptionRow& row) { return row.section == section; };
  if (std::none_of(rows_.begin(), rows_.end(), in_section)) {
    throw std::invalid_argument("there is no section [" + section + "]");
  }
  const std::string name = "[" + section + "] " + key;
  const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const OptionRow& candidate) {
    return in_section(candidate) && candidate.key == key;
  });
  if (row == rows_.end()) {
    throw std::invalid_argument("there is no option " + name);
  }
  try {
    row->write(value);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + " " + error.what() + ", not \"" + value + "\"");
  }
}

void OptionTable::apply(const std::vector<IniEntry>& entries) const {
  for (const IniEntry& entry : entries) {
    try {
      set(entry.section, entry.key, entry.value);
    } catch (const std::invalid_argument& error) {
      throw IniError(entry.line, error.what());
    }
  }
}

std::string OptionTable::dump() const {
  std::string text, open_section;
  for (const OptionRow& row : rows_) {
    if (row.section != open_section) {
      text += (text.empty() ? "[" : "\n[") + row.section + "]\n";
      open_section = row.section;
    }
    std::string line = row.key + " = " + row.read();
    line.resize(std::max(line.size() + 2, size_t{36}), ' ');
    text += line + "; " + row.meaning + "\n";
  }
  return text;
}

}  // namespace sbox
