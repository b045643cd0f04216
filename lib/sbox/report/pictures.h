// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a person wants to see to believe a merge.
#pragma once

#include <string>
#include <vector>

#include "sbox/core/map.h"
#include "sbox/core/progress.h"
#include "sbox/merge_result.h"

namespace sbox {

/// A PNG file to be.
struct Picture {
  std::string file_name;  ///< No folder; distinct from all others, even without regard to case.
  std::vector<unsigned char> png;  ///< The bytes of the file.
};

/// features_NAME.png of each map; for each map its most confident pair, whatever the verdict, as
/// boxes_A_B.png and overlay_A_B.png; and the merged maps, merged.png first. `maps` are those that
/// `result` came from. Works on up to `threads` threads (0: one a core).
[[nodiscard]] std::vector<Picture> drawPictures(const std::vector<Map>& maps,
                                                const MergeResult& result, int threads = 0,
                                                const ProgressFunction& progress = {});

}  // namespace sbox
