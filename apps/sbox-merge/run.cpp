// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/run.h"

#include <filesystem>
#include <iostream>

#include "sbox-merge/group_key_frames.h"
#include "sbox-merge/interrupt.h"
#include "sbox-merge/load_inputs.h"
#include "sbox-merge/progress_line.h"
#include "sbox-merge/write_outputs.h"
#include "sbox/config/config_file.h"
#include "sbox/io/file_error.h"
#include "sbox/io/share_file.h"
#include "sbox/merge.h"
#include "sbox/report/summary.h"

namespace sbox::app {
namespace {

void tellDetails(const MergeResult& result, const GroupKeyFrames& key_frames) {
  for (const std::string& line : detailLines(result)) {
    std::cerr << line << "\n";
  }
  for (const std::string& line : key_frames.details) {
    std::cerr << line << "\n";
  }
}

void tellWarnings(const Arguments& arguments, const MergeResult& result) {
  std::vector<std::string> warnings = warningLines(result);
  const std::optional<int>& wanted = arguments.merge.reference;
  if (wanted && !result.merged.empty() && result.reference != *wanted) {
    warnings.push_back(arguments.inputs[static_cast<size_t>(*wanted)] +
                       " is not part of the merged map, which takes the frame of " +
                       arguments.inputs[static_cast<size_t>(result.reference)]);
  }
  if (result.merged.empty()) {
    for (const std::string& file : outputsOfMerge(arguments)) {
      std::error_code ignored;
      if (std::filesystem::exists(file, ignored)) {
        warnings.push_back(file + " is left as it was, as nothing was merged");
      }
    }
  }
  for (const std::string& warning : warnings) {
    std::cerr << "sbox-merge: warning: " << warning << "\n";
  }
}

void tellResult(const MergeResult& result, const std::vector<std::string>& files) {
  for (const std::string& line : summaryLines(result, files)) {
    std::cout << line << "\n";
  }
  std::cout << std::flush;
}

void tellShare(const Arguments& arguments, const MatchedShare& share) {
  if (!arguments.quiet) {
    std::cout << arguments.report << ": " << share.pairs.size() << " pairs matched, share "
              << share.share.number << " of " << share.share.count << "\n"
              << std::flush;
  }
}

std::vector<MatchedShare> loadShares(const std::vector<std::string>& files) {
  std::vector<MatchedShare> shares;
  shares.reserve(files.size());
  for (const std::string& file : files) {
    shares.push_back(loadShare(file));
  }
  return shares;
}

/// What the shares know of the pairs; nothing without shares.
MatchStore joined(const std::vector<MatchedShare>& shares, const Inputs& inputs,
                  const Arguments& arguments, const ProgressFunction& tell) {
  if (shares.empty()) {
    return {};
  }
  try {
    return joinShares(inputs.maps, arguments.merge, shares, tell);
  } catch (const ShareError& error) {
    throw FileError(arguments.joined[error.index()], error.what());
  }
}

}  // namespace

int run(const Arguments& arguments, const RunSlams& run_slams) {
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
  const std::vector<MatchedShare> shares = loadShares(arguments.joined);
  const Inputs inputs = loadInputs(arguments, run_slams, tell);
  const double load_seconds = stopwatch.seconds();
  if (arguments.share) {
    const MatchedShare share = matchShare(inputs.maps, arguments.merge, *arguments.share, tell);
    writeShare(share, arguments);
    line.wipe();
    tellShare(arguments, share);
    return 0;
  }
  MatchStore known = joined(shares, inputs, arguments, tell);
  MergeResult result = mergeMaps(inputs.maps, arguments.merge, known, tell);
  result.seconds.load = load_seconds;
  GroupKeyFrames key_frames;
  if (arguments.fuse_observations) {
    const Stopwatch remap_stopwatch;
    key_frames = remapGroups(inputs, arguments, result, tell);
    result.seconds.fusion += remap_stopwatch.seconds();
  } else if (!arguments.simplemap.empty()) {
    key_frames = groupKeyFrames(inputs, result);
  }
  const std::vector<std::string> files =
      writeOutputs(inputs, key_frames.groups, arguments, result, stopwatch.seconds(), tell);
  line.wipe();
  if (arguments.verbose) {
    tellDetails(result, key_frames);
  }
  if (!arguments.quiet) {
    tellWarnings(arguments, result);
    tellResult(result, files);
  }
  constexpr int not_all_placed = 3;
  return result.status == MergeStatus::Merged ? 0 : not_all_placed;
}

}  // namespace sbox::app
