// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// BoxAligner's options in the way of MRPT: one section, keys with the stage in front.
#include <mrpt/config/CConfigFileBase.h>

#include <ostream>
#include <stdexcept>
#include <string>

#include "sbox/config/describe_options.h"
#include "sbox/slam/box_aligner.h"

namespace sbox {
namespace {

std::string keyOf(const OptionRow& row) {
  return row.section == "merge" ? row.key : row.section + "." + row.key;
}

}  // namespace

void BoxAligner::Options::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                             const std::string& section) {
  const OptionTable table = describePairOptions(merge);
  for (const OptionRow& row : table.rows()) {
    const std::string key = keyOf(row);
    const std::string value = source.read_string(section, key, "");
    if (value.empty()) {
      continue;
    }
    try {
      row.write(value);
    } catch (const std::invalid_argument& error) {
      std::string reason = "[";
      reason.append(section).append("] ").append(key).append(" ").append(error.what());
      throw std::runtime_error(reason);
    }
  }
}

void BoxAligner::Options::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                                           const std::string& section) const {
  MergeOptions copy = merge;
  const OptionTable table = describePairOptions(copy);
  for (const OptionRow& row : table.rows()) {
    target.write(section, keyOf(row), row.read(), -1, -1, row.meaning);
  }
}

void BoxAligner::Options::dumpToTextStream(std::ostream& out) const {
  MergeOptions copy = merge;
  const OptionTable table = describePairOptions(copy);
  for (const OptionRow& row : table.rows()) {
    out << keyOf(row) << " = " << row.read() << "  // " << row.meaning << "\n";
  }
}

}  // namespace sbox
