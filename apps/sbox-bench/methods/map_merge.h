// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What ROS's multirobot_map_merge does with two maps whose places are unknown. The package needs
// ROS, so this is a rebuild: the same parts of OpenCV's stitching module in the same order and with
// the same defaults as combine_grids::MergingPipeline of hrnr/m-explore and robo-friends/
// m-explore-ros2 (map_merge/src/combine_grids/merging_pipeline.cpp). AKAZE keypoints on the cells
// as bytes, AffineBestOf2NearestMatcher, leaveBiggestComponent at the confidence threshold,
// AffineBasedEstimator, BundleAdjusterAffinePartial. Where the package goes on with the first map
// alone and calls that a success, this refuses. It fits a similarity and looks at neither its scale
// nor the cells' size; the rigid transform that is judged has its rotation and moves the centre of
// map b to the same place.
#pragma once

#include "sbox-bench/method.h"
#include "sbox/core/state_grid.h"

namespace sbox::bench {

struct MapMergeOptions {
  StateOptions states;  ///< Which cells are published as free (0), occupied (100), unknown (-1).
  double confidence = 1.0;  ///< The package's estimation_confidence: inliers / (8 + 0.3 matches) of
                            ///< two maps, below which they are not merged.
};

[[nodiscard]] Method mapMergeMethod(const MapMergeOptions& options = {});

}  // namespace sbox::bench
