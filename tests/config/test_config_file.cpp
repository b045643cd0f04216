// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <stdexcept>

#include "catch.h"
#include "sbox/config/config_file.h"
#include "sbox/config/describe_options.h"

using namespace sbox;

namespace {

/// Gives the option another valid value; its meaning ends with the ends of its range, or names all
/// words that it may be.
bool change(const OptionRow& row) {
  const std::string before = row.read();
  std::istringstream meaning(row.meaning);
  for (std::string word; meaning >> word;) {
    try {
      row.write(word);
    } catch (const std::invalid_argument&) {
      continue;
    }
    if (row.read() != before) {
      return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("every option has its own lower-case name and a meaning") {
  MergeOptions options;
  const OptionTable table = describeOptions(options);
  std::set<std::string> names;
  for (const OptionRow& row : table.rows()) {
    const std::string name = row.section + "/" + row.key;
    INFO(name);
    CHECK(names.insert(name).second);
    CHECK(std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::isupper(c); }));
    CHECK(row.meaning.size() > 10);
  }
}

TEST_CASE("the defaults of all stages are within their ranges") {
  MergeOptions options;
  const std::string dump = dumpConfig(options);
  CHECK_NOTHROW(describeOptions(options).apply(parseIni(dump)));
  CHECK(dumpConfig(options) == dump);
}

TEST_CASE("each option has a variable of its own") {
  MergeOptions defaults;
  const OptionTable before = describeOptions(defaults);
  for (size_t i = 0; i < before.rows().size(); ++i) {
    INFO(before.rows()[i].section + "/" + before.rows()[i].key);
    MergeOptions options;
    const OptionTable table = describeOptions(options);
    CHECK(change(table.rows()[i]));
    for (size_t j = 0; j < table.rows().size(); ++j) {
      const bool same = table.rows()[j].read() == before.rows()[j].read();
      CHECK((same || i == j));
    }
  }
}
