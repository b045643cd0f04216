// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/run.h"

#include <iostream>

#include "sbox-merge/interrupt.h"
#include "sbox-merge/progress_line.h"
#include "sbox-merge/write_outputs.h"
#include "sbox/config/config_file.h"
#include "sbox/core/parallel.h"
#include "sbox/core/state_grid.h"
#include "sbox/io/file_error.h"
#include "sbox/io/load_map.h"
#include "sbox/merge.h"
#include "sbox/report/summary.h"

namespace sbox::app {
namespace {

/// A map that no method could ever match is an input that cannot be used.
void checkUsable(const Map& map) {
  if (map.width() < 2 || map.height() < 2) {
    throw FileError(map.name, "is too small to match: it has " + std::to_string(map.width()) +
                                  " x " + std::to_string(map.height()) + " cells");
  }
  if (!hasOccupiedCell(map)) {
    throw FileError(map.name, "has no occupied cell, so there are no walls to match");
  }
}

std::vector<Map> loadMaps(const Arguments& arguments, const ProgressFunction& tell) {
  std::vector<Map> maps(arguments.inputs.size());
  const auto count = static_cast<int>(maps.size());
  StageProgress progress(tell, "maps loaded", count);
  parallelFor(count, arguments.merge.threads, [&](int i) {
    progress.partBegins();
    const auto index = static_cast<size_t>(i);
    maps[index] = loadMap(arguments.inputs[index], {arguments.resolution});
    checkUsable(maps[index]);
    progress.partDone();
  });
  return maps;
}

void tellDetails(const MergeResult& result) {
  for (const std::string& line : detailLines(result)) {
    std::cerr << line << "\n";
  }
}

void tellResult(const Arguments& arguments, const MergeResult& result,
                const std::vector<std::string>& files) {
  const std::optional<int>& wanted = arguments.merge.reference;
  if (wanted && !result.merged.empty() && result.reference != *wanted) {
    std::cerr << "sbox-merge: warning: " << arguments.inputs[static_cast<size_t>(*wanted)]
              << " is not part of the merged map, which takes the frame of "
              << arguments.inputs[static_cast<size_t>(result.reference)] << "\n";
  }
  for (const std::string& line : summaryLines(result, files)) {
    std::cout << line << "\n";
  }
  std::cout << std::flush;
}

}  // namespace

int run(const Arguments& arguments) {
  if (arguments.dump_config) {
    std::cout << dumpConfig(arguments.merge) << std::flush;
    return 0;
  }
  const Stopwatch stopwatch;
  ProgressLine line(!arguments.quiet);
  const ProgressFunction tell = [&](const std::string& stage, int done, int total) {
    checkInterrupt();
    line.show(stage, done, total);
  };
  checkOutputs(arguments);
  const std::vector<Map> maps = loadMaps(arguments, tell);
  const double load_seconds = stopwatch.seconds();
  MergeResult result = mergeMaps(maps, arguments.merge, tell);
  result.seconds.load = load_seconds;
  const std::vector<std::string> files =
      writeOutputs(maps, arguments, result, stopwatch.seconds(), tell);
  line.wipe();
  if (arguments.verbose) {
    tellDetails(result);
  }
  if (!arguments.quiet) {
    tellResult(arguments, result, files);
  }
  constexpr int not_all_placed = 3;
  return result.status == MergeStatus::Merged ? 0 : not_all_placed;
}

}  // namespace sbox::app
