// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A merged group as a graph of poses, to go on with in MRPT (graph-slam) and its like.
#pragma once

#include <string>

#include "sbox/merge_result.h"

namespace sbox {

/// The group as MRPT's `.graph`: a `VERTEX2 map x y phi` for each map, by its number in the input,
/// in the frame of the reference, which `FIX` names; an `EDGE2 a b x y phi` for each pair that
/// agrees, with its candidate that does and the upper triangle of the information that it has in
/// the solution, row by row: xx xy xp yy yp pp, as MRPT reads it (TORO's own order is another; its
/// graph-slam 2.5 heeds no information).
/// Metres and radians. Comments name the maps, and the pairs that do not agree.
[[nodiscard]] std::string graphText(const MergeResult& result, const MergedGroup& group);

}  // namespace sbox
