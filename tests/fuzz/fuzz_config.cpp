// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a --config file: options or a FileError; and the options that were read are dumped
// and read back the same.
#include "fuzz/input_folder.h"
#include "sbox/config/config_file.h"
#include "sbox/io/file_error.h"

using namespace sbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFolder folder;
  MergeOptions options;
  try {
    loadConfig(folder.write("in.ini", {data, data + size}), options);
  } catch (const FileError&) {
    return 0;
  }
  const std::string dumped = dumpConfig(options);
  MergeOptions again;
  loadConfig(folder.write("again.ini", {dumped.begin(), dumped.end()}), again);
  fuzz::require(dumpConfig(again) == dumped);
  return 0;
}
