// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a .rawlog that a process of its own survives reading, as sbox-merge asks first:
// steps with sound scans or a FileError.
#include <algorithm>

#include "fuzz/input_folder.h"
#include "fuzz/quiet_death.h"
#include "sbox-merge/trial_reading.h"
#include "sbox/io/file_error.h"
#include "sbox/mapping/sound_scan.h"
#include "sbox/slam/scan_log.h"

using namespace sbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFolder folder;
  const std::string path = folder.write("in.rawlog", {data, data + size});
  ScanLog log;
  try {
    app::tryReading(path, [&] {
      fuzz::dieQuietly();
      static_cast<void>(loadScanLog(path));
    });
    log = loadScanLog(path);
  } catch (const FileError&) {
    return 0;
  }
  fuzz::require(!log.steps.empty());
  for (const LogStep& step : log.steps) {
    fuzz::require(step.moved && step.seen && !step.seen->empty());
    fuzz::require(std::all_of(step.seen->begin(), step.seen->end(),
                              [](const auto& observation) { return isSound(*observation); }));
  }
  return 0;
}
