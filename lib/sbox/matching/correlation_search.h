// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exhaustive search for what no corner or box proposes: the evidence of every translation at once,
// by correlating coarse pictures of both maps (fast Fourier transform), heading by heading.
#pragma once

#include <vector>

#include "sbox/alignment/evidence.h"
#include "sbox/features/map_features.h"
#include "sbox/matching/heading_candidates.h"
#include "sbox/matching/hypothesis.h"

namespace sbox {

/// How fine the search is.
struct CorrelationSearchOptions {
  HeadingOptions headings;  ///< Which turns are tried.
  double resolution = 0.8;  ///< Of the pictures' cells, metres; coarser where maps are large ...
  int most_cells = 256;     ///< ... so that no map is more than this many cells wide or high.
  double wall_blur = 0.5;   ///< Standard deviation at which walls agree, metres.
  double min_agree = 0.2;   ///< Share of the common walls below which a translation is passed over.
  double separation = 1.5;  ///< Between two translations of one heading, metres.
  int per_heading = 20;     ///< Translations kept of each heading.
};

/// The most plausible translations of each heading, all headings together in descending order.
/// `evidence` says what conflicts; the number of threads (0: one a core) matters only for the time.
[[nodiscard]] std::vector<Hypothesis> searchByCorrelation(
    const MapFeatures& a, const MapFeatures& b, const CorrelationSearchOptions& options = {},
    const EvidenceOptions& evidence = {}, int threads = 1);

}  // namespace sbox
