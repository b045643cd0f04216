// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/config/config_file.h"

#include "sbox/config/describe_options.h"
#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"

namespace sbox {

void loadConfig(const std::string& path, MergeOptions& options) {
  constexpr std::uint64_t most_bytes = 1 << 20;
  const Bytes bytes = readFile(path, most_bytes);
  try {
    describeOptions(options).apply(parseIni({bytes.begin(), bytes.end()}));
  } catch (const IniError& error) {
    throw FileError(path, error.what());
  }
}

std::string dumpConfig(const MergeOptions& options) {
  MergeOptions copy = options;
  return describeOptions(copy).dump();
}

}  // namespace sbox
