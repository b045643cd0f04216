// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Headings at which the walls of two maps can face the same ways, whatever the angles between them.
#pragma once

#include <vector>

#include "sbox/features/map_features.h"

namespace sbox {

/// Which turns are candidates.
struct HeadingOptions {
  double step = 4.0;       ///< Between neighbouring headings, degrees.
  double smoothing = 3.0;  ///< Standard deviation of the histograms of facing directions, degrees.
  double min_share = 0.6;  ///< Of the best heading's correlation.
  int max_headings = 45;   ///< The best are kept.
};

/// Headings of map b in map a, radians, at which the histograms of the directions that their wall
/// points face correlate well; the best first. They lie on a lattice through the best of all.
[[nodiscard]] std::vector<double> findHeadings(const MapFeatures& a, const MapFeatures& b,
                                               const HeadingOptions& options = {});

}  // namespace sbox
