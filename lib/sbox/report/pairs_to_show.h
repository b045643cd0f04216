// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sbox/merge_result.h"

namespace sbox {

/// For each map its most confident pair, whatever the verdict, in the order of result.pairs: enough
/// to see why it is where it is, or why it is nowhere, and linear in the maps where all pairs would
/// be too many to look at. The pointers are into result.pairs.
[[nodiscard]] std::vector<const MapPair*> pairsToShow(const MergeResult& result);

}  // namespace sbox
