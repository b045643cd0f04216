// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From maps to merged map: the whole method as one function.
#pragma once

#include <vector>

#include "sbox/core/map.h"
#include "sbox/core/progress.h"
#include "sbox/match_all.h"
#include "sbox/merge_options.h"
#include "sbox/merge_result.h"

namespace sbox {

/// Merges the maps that belong together. The merged map is that of the largest group, in the frame
/// of options.reference where that is a member, else of the group's first map. Maps are named by
/// their `name`. Throws std::invalid_argument with less than two maps or a reference that is not
/// one of them, and std::length_error if a merged map would be too large (see FusionOptions).
[[nodiscard]] MergeResult mergeMaps(const std::vector<Map>& maps, const MergeOptions& options = {},
                                    const ProgressFunction& progress = {});

/// The same with what is known of these maps by these options already; the rest is added to it.
[[nodiscard]] MergeResult mergeMaps(const std::vector<Map>& maps, const MergeOptions& options,
                                    MatchStore& known, const ProgressFunction& progress = {});

}  // namespace sbox
