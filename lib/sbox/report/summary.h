// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The result in words: what the command prints.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/pose.h"
#include "sbox/merge_result.h"

namespace sbox {

/// "x 1.234 m, y -0.567 m, phi 12.34 deg".
[[nodiscard]] std::string poseText(const Pose2D& pose);

/// What was merged, then for each map where it lies or why it is left out. Two maps take one line;
/// more take a line each. `merged_files` are the names under which result.merged was written, in
/// its order; they may be fewer.
[[nodiscard]] std::vector<std::string> summaryLines(const MergeResult& result,
                                                    const std::vector<std::string>& merged_files);

/// What a user should look at before the result is used: a line for each map that lies elsewhere
/// than it was said to.
[[nodiscard]] std::vector<std::string> warningLines(const MergeResult& result);

/// What each stage found, for those who want to know more: a line for each map, pair and merged
/// map, and one for the time that each stage took.
[[nodiscard]] std::vector<std::string> detailLines(const MergeResult& result);

}  // namespace sbox
