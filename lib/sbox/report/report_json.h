// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The report that scripts read.
#pragma once

#include <string>
#include <vector>

#include "sbox/merge_result.h"

namespace sbox {

/// The result as JSON text (version 1). `merged_files` are the names under which result.merged was
/// written, in its order; they may be fewer. Angles are in radians, lengths in metres. What is not
/// known is null. Bytes of names that are not UTF-8 are replaced.
[[nodiscard]] std::string reportJson(const MergeResult& result,
                                     const std::vector<std::string>& merged_files);

}  // namespace sbox
