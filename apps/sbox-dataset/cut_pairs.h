// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Map pairs that share less than those they are cut from: harder, and with truth as good.
#pragma once

#include <string>

#include "sbox-bench/annotated_pairs.h"
#include "sbox/core/map.h"

namespace sbox::dataset {

/// Across which line, the main axis of all that either map saw as free, the maps are cut, and where
/// along it: as the share of free cells of both maps that lie before.
struct CutOptions {
  double a_until = 0.65;  ///< Map a keeps what lies before this.
  double b_from = 0.35;   ///< Map b keeps what lies behind this; above a_until nothing is shared.
  double tilt_deg = 0;    ///< Turns the axis, counter-clockwise, degrees.
};

/// What is left of two maps, on grids as large as before, and what is known about it.
struct CutPair {
  Map a;
  Map b;
  bench::AnnotatedPair pair;
};

/// Cuts both maps of an annotated pair. The new truth is the best fit of the points that both maps
/// keep, if there are four (drifted maps fit otherwise there than as a whole, whose rotation counts
/// as right, too), else that of all. Throws std::invalid_argument for a pair with nothing in
/// common, and std::runtime_error if no cell is free.
[[nodiscard]] CutPair cutPair(const Map& a, const Map& b, const bench::AnnotatedPair& pair,
                              double resolution, const CutOptions& options);

/// Cuts each pair of a folder that has something in common, and writes maps (`000a.gridmap.gz`) and
/// `pairs.json` into another, which is made if it is not there.
void cutPairs(const std::string& from, const std::string& to, const CutOptions& options);

}  // namespace sbox::dataset
