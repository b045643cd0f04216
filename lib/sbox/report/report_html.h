// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The result as a page that a person can look into: verdicts in words, overlays to fade and toggle,
// features, poses.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/map.h"
#include "sbox/core/progress.h"
#include "sbox/merge_result.h"

namespace sbox {

/// One HTML file that needs nothing else. `maps` are those that `result` came from; `merged_files`
/// are the names under which result.merged was written, in its order; they may be fewer. The same
/// result gives the same bytes on any number of threads (0: one a core); times are left out.
[[nodiscard]] std::string reportHtml(const std::vector<Map>& maps, const MergeResult& result,
                                     const std::vector<std::string>& merged_files, int threads = 0,
                                     const ProgressFunction& progress = {});

}  // namespace sbox
