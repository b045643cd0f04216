// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <set>

#include "catch.h"
#include "sbox/config/config_file.h"
#include "sbox/config/describe_options.h"

using namespace sbox;

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
