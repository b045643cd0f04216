// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/hand_logs_over.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sbox-merge/arguments.h"
#include "sbox-merge/load_inputs.h"
#include "sbox/io/file_error.h"

namespace sbox::app {

void handLogsOver(const Arguments& arguments, const ProgressFunction& /*tell*/,
                  Inputs& /*inputs*/) {
  const auto log = std::find_if(arguments.inputs.begin(), arguments.inputs.end(), isRawlog);
  if (log == arguments.inputs.end()) {
    return;
  }
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string program = (folder / SBOX_MERGE_WITH_SLAM).lexically_normal();
  std::vector<std::string> words = arguments.command_line;
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
  throw FileError(*log, "needs SLAM, and " + program +
                            " cannot be run: build all of sbox-merge, or map the log first");
}

}  // namespace sbox::app
