// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/run.h"

#include <iostream>

#include "sbox-merge/group_key_frames.h"
#include "sbox-merge/interrupt.h"
#include "sbox-merge/load_inputs.h"
#include "sbox-merge/progress_line.h"
#include "sbox-merge/write_outputs.h"
#include "sbox/config/config_file.h"
#include "sbox/merge.h"
#include "sbox/report/summary.h"

namespace sbox::app {
namespace {

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
  const Inputs inputs = loadInputs(arguments, tell);
  const double load_seconds = stopwatch.seconds();
  MergeResult result = mergeMaps(inputs.maps, arguments.merge, tell);
  result.seconds.load = load_seconds;
  if (arguments.fuse_observations) {
    const Stopwatch remap_stopwatch;
    remapGroups(inputs, arguments, result);
    result.seconds.fusion += remap_stopwatch.seconds();
  }
  const std::vector<std::string> files =
      writeOutputs(inputs, arguments, result, stopwatch.seconds(), tell);
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
