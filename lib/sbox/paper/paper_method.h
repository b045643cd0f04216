// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The published method as it is printed, misprints aside: B. Chen, S. Li, H. Zhao, L. Liu, "Map
// Merging with Suppositional Box for Multi-Robot Indoor Mapping", Electronics 2021, 10(7), 815. It
// is the baseline that the default method is measured against (`--method paper`).
#pragma once

#include <vector>

#include "sbox/core/feature_set.h"
#include "sbox/core/pair_result.h"
#include "sbox/core/state_grid.h"
#include "sbox/paper/best_pair.h"
#include "sbox/paper/boxes.h"
#include "sbox/paper/hough_lines.h"
#include "sbox/paper/outline_filter.h"
#include "sbox/paper/point_clusters.h"
#include "sbox/paper/vertical_points.h"

namespace sbox {

/// Options of the paper's sections 3.1 and 3.2.
struct PaperOptions {
  StateOptions states;                   ///< Free, occupied or unknown.
  HoughOptions hough;                    ///< Section 3.1.1, lines.
  VerticalPointOptions vertical_points;  ///< Section 3.1.1, eq. 1.
  ClusterOptions clusters;               ///< Section 3.1.2, eq. 2.
  OutlineOptions outline;                ///< Section 3.1.2, the filter.
  BoxOptions boxes;                      ///< Section 3.1.3.
  BestPairOptions best_pair;             ///< Section 3.2.
};

/// The features of one map. Boxes are in the grid frame (metres from the lower-left corner of
/// `states`, x along its rows); feature_set holds the same in the map frame.
struct PaperFeatures {
  StateGrid states;                     ///< The map's cells.
  std::vector<SuppositionalBox> boxes;  ///< In the grid frame, largest first.
  FeatureSet feature_set;               ///< In the map frame, boxes in the same order.
};

/// Section 3.1. A map without lines has no boxes; that is no error.
[[nodiscard]] PaperFeatures extractPaperFeatures(const Map& map, const PaperOptions& options = {});

/// Sections 3.2 and 3.3. Accepted if enough rough matches agree with the best pair's transform,
/// which is the paper's own condition; the pose is that of the Kalman step. The paper has no
/// measure of confidence: the one given here is the share of right answers measured on the Halmstad
/// E5 maps, so it knows accepted from rejected and nothing else. Of maps with different cell sizes
/// the coarser is resampled to the finer, and the reason says so; `matched_boxes` then names those
/// boxes of the map as it was that lie nearest.
[[nodiscard]] PairResult matchPaper(const PaperFeatures& a, const PaperFeatures& b,
                                    const PaperOptions& options = {});

}  // namespace sbox
