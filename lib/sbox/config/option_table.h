// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One table from which options are read, dumped and explained: each stage lists its options once
// (see describe_options.h), with key, unit, range and meaning.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sbox/config/ini_text.h"

namespace sbox {

/// Values an option may take, both ends included, in the unit of the file.
struct Range {
  double low;   ///< The least value allowed.
  double high;  ///< The largest value allowed.
};

/// A row of the table, bound to the variable that holds the option.
struct OptionRow {
  std::string section;                ///< Of the ini file.
  std::string key;                    ///< In its section.
  std::string meaning;                ///< With unit and range.
  std::function<std::string()> read;  ///< The value as text, in the unit of the file.
  /// Throws std::invalid_argument saying what the value must be.
  std::function<void(const std::string&)> write;
};

/// Rows in the order in which they were added.
class OptionTable {
 public:
  /// The rows that follow belong to this section.
  void section(const std::string& name) { section_ = name; }

  /// A length, in metres.
  void metres(const std::string& key, double& value, Range range, const std::string& meaning);
  /// Radians in the variable, degrees in files and in the range.
  void degrees(const std::string& key, double& value, Range range, const std::string& meaning);
  /// A number without a unit, or with the one that the meaning names.
  void number(const std::string& key, double& value, Range range, const std::string& meaning);
  /// A whole number without a unit.
  void count(const std::string& key, int& value, Range range, const std::string& meaning);
  /// As above; the range begins at 0 or above.
  void count(const std::string& key, size_t& value, Range range, const std::string& meaning);

  /// One of a few words.
  template <typename Enum>
  void choice(const std::string& key, Enum& value,
              const std::vector<std::pair<std::string, Enum>>& names, const std::string& meaning) {
    std::vector<std::string> words;
    words.reserve(names.size());
    for (const auto& name : names) {
      words.push_back(name.first);
    }
    addChoice(
        key, words, meaning,
        [&value, names] {
          for (size_t i = 0; i < names.size(); ++i) {
            if (names[i].second == value) {
              return i;
            }
          }
          return names.size();
        },
        [&value, names](size_t i) { value = names[i].second; });
  }

  /// All rows, in the order added.
  [[nodiscard]] const std::vector<OptionRow>& rows() const { return rows_; }

  /// Sets one variable. Throws std::invalid_argument on an unknown section or key and a bad value.
  void set(const std::string& section, const std::string& key, const std::string& value) const;

  /// Sets the variables. Throws IniError on an unknown section or key and on a bad value.
  void apply(const std::vector<IniEntry>& entries) const;

  /// Ini text with every option, its present value and its meaning as a comment; apply() reads it
  /// back to the same values.
  [[nodiscard]] std::string dump() const;

 private:
  void addNumber(const std::string& key, double& value, Range range, double file_unit,
                 const std::string& meaning);
  template <typename Whole>
  void addCount(const std::string& key, Whole& value, Range range, const std::string& meaning);
  void addChoice(const std::string& key, const std::vector<std::string>& words,
                 const std::string& meaning, const std::function<size_t()>& read,
                 const std::function<void(size_t)>& write);

  std::string section_;
  std::vector<OptionRow> rows_;
};

}  // namespace sbox
