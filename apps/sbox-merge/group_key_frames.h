// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox-merge/arguments.h"
#include "sbox-merge/load_inputs.h"
#include "sbox/core/key_frame.h"
#include "sbox/core/progress.h"
#include "sbox/merge_result.h"

namespace sbox::app {

/// The key frames of each merged group's maps, in the frame of its reference.
struct GroupKeyFrames {
  std::vector<KeyFrames> groups;     ///< In the order of MergeResult::merged.
  std::vector<std::string> details;  ///< What --verbose tells of them.
};

/// Of maps as they were placed.
[[nodiscard]] GroupKeyFrames groupKeyFrames(const Inputs& inputs, const MergeResult& result);

/// Makes the merged maps anew of all that was seen, in place of those joined by cells; the key
/// frames are those of the new maps.
[[nodiscard]] GroupKeyFrames remapGroups(const Inputs& inputs, const Arguments& arguments,
                                         MergeResult& result, const ProgressFunction& tell);

}  // namespace sbox::app
