// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox-merge/load_inputs.h"
#include "sbox/merge_result.h"

namespace sbox::app {

/// The key frames of a merged group's maps, in the frame of its reference.
[[nodiscard]] KeyFrames groupKeyFrames(const Inputs& inputs, const MergeResult& result,
                                       const MergedGroup& group);

/// Makes the merged maps anew of all that was seen, in place of those joined by cells.
void remapGroups(const Inputs& inputs, const Arguments& arguments, MergeResult& result);

}  // namespace sbox::app
