// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/run_slams.h"

#include <iostream>
#include <string>
#include <utility>

#include "sbox-merge/trial_reading.h"
#include "sbox/core/parallel.h"
#include "sbox/io/file_error.h"
#include "sbox/slam/run_slam.h"

namespace sbox::app {
namespace {

void warn(const Arguments& arguments, const ScanLog& log, size_t index) {
  if (log.cut_off && !arguments.quiet) {
    std::cerr << "sbox-merge: warning: " << arguments.inputs[index]
              << " is cut off or damaged: only its first " << log.steps.size()
              << " scans are used\n";
  }
}

}  // namespace

void runSlams(const Arguments& arguments, const ProgressFunction& tell, Inputs& inputs) {
  std::vector<std::pair<size_t, ScanLog>> logs;
  size_t steps = 0;
  for (size_t i = 0; i < arguments.inputs.size(); ++i) {
    if (isRawlog(arguments.inputs[i])) {
      const std::string& path = arguments.inputs[i];
      tryReading(path, [&] { static_cast<void>(loadScanLog(path)); });
      logs.emplace_back(i, loadScanLog(path));
      steps += logs.back().second.steps.size();
      warn(arguments, logs.back().second, i);
    }
  }
  StageProgress progress(tell, "scans mapped", static_cast<int>(steps));
  // RBPF-SLAM draws from one random generator.
  const int threads = arguments.slam.method == SlamMethod::Rbpf ? 1 : arguments.merge.threads;
  parallelFor(static_cast<int>(logs.size()), threads, [&](int number) {
    auto& [index, log] = logs[static_cast<size_t>(number)];
    try {
      inputs.key_frames[index] =
          runSlam(std::move(log), arguments.slam, [&] { progress.partDone(); });
    } catch (const SlamError& error) {
      throw FileError(arguments.inputs[index], error.what());
    }
  });
}

}  // namespace sbox::app
