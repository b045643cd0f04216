// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Figure 15: how many matched features are right, boxes' corners against image keypoints.
#pragma once

#include <string>
#include <vector>

#include "sbox-bench/run_method.h"

namespace sbox::paper {

/// What one kind of feature gives on one pair of maps.
struct MatchCount {
  int matches = 0;  ///< Points matched: four a box; keypoints that are each other's nearest.
  int right = 0;    ///< Of them, those near their partner under the true transform.
};

/// All kinds on one pair.
struct PairMatches {
  std::string group;
  std::string a;
  std::string b;
  double tolerance = 0;  ///< Metres up to which a match is right.
  MatchCount boxes;      ///< By the default method.
  MatchCount paper;      ///< By the published method.
  MatchCount orb;
  MatchCount sift;
};

/// Counts over the pairs of a folder that have something in common. A match is right within half a
/// metre plus the pair's own rigid floor: drifted maps part by so much under the best transform.
[[nodiscard]] std::vector<PairMatches> countMatches(const bench::LoadedFolder& loaded, int threads);

}  // namespace sbox::paper
