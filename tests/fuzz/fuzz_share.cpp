// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a file of --join: a share or a FileError; and the share that was read is written and
// read back the same.
#include "fuzz/input_folder.h"
#include "sbox/io/file_error.h"
#include "sbox/io/share_file.h"

using namespace sbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFolder folder;
  MatchedShare share;
  try {
    share = loadShare(folder.write("in.json", {data, data + size}));
  } catch (const FileError&) {
    return 0;
  }
  const std::vector<std::string> names(share.map_digests.size(), "map");
  const std::string text = shareJson(share, names);
  const std::string path = folder.write("again.json", {text.begin(), text.end()});
  fuzz::require(shareJson(loadShare(path), names) == text);
  return 0;
}
