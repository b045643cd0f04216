// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox-merge/arguments.h"
#include "sbox-merge/load_inputs.h"
#include "sbox/core/progress.h"
#include "sbox/merge_result.h"

namespace sbox::app {

/// The outputs that are asked for and written only where something is merged, but for those of
/// further groups.
[[nodiscard]] std::vector<std::string> outputsOfMerge(const Arguments& arguments);

/// Throws FileError if it is plain now that an output cannot be written; writes nothing.
void checkOutputs(const Arguments& arguments);

/// Writes merged maps, pictures and report, all or none; `group_key_frames` are those of each
/// merged map, where they are asked for. `seconds_before` went by already; they and the time taken
/// here are added to result.seconds. Returns the names of the merged maps, in the order of
/// result.merged. Throws FileError.
std::vector<std::string> writeOutputs(const Inputs& inputs,
                                      const std::vector<KeyFrames>& group_key_frames,
                                      const Arguments& arguments, MergeResult& result,
                                      double seconds_before, const ProgressFunction& tell);

/// Writes what --pairs found as the report, whole or not at all. Throws FileError.
void writeShare(const MatchedShare& share, const Arguments& arguments);

}  // namespace sbox::app
