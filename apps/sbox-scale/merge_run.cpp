// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-scale/merge_run.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>

#include "sbox/core/stopwatch.h"

namespace sbox::scale {

MergeRun runMerge(const std::string& command, const std::filesystem::path& folder,
                  const std::vector<std::string>& maps, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"sbox-merge", "--in"};
  words.insert(words.end(), maps.begin(), maps.end());
  words.insert(words.end(), {"--report", "r.json", "-q"});
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);

  std::filesystem::remove(folder / "r.json");
  const Stopwatch stopwatch;
  const pid_t child = fork();
  if (child < 0) {
    throw std::runtime_error("no further process can be started");
  }
  if (child == 0) {
    if (chdir(folder.c_str()) == 0) {
      execv(command.c_str(), argv.data());
    }
    _exit(127);
  }
  MergeRun run;
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  run.seconds = stopwatch.seconds();
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.peak_mib = static_cast<double>(usage.ru_maxrss) / 1024;
  std::ifstream file(folder / "r.json");
  run.report = nlohmann::json::parse(file, nullptr, false);
  return run;
}

}  // namespace sbox::scale
