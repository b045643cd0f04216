// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two maps over each other: where they agree, and where a wall of one stands in free space of the
// other.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "sbox/core/pose.h"
#include "sbox/core/state_grid.h"

namespace sbox {

struct OverlayOptions {
  double agree_within = 0.2;    ///< Walls this near to each other agree, in metres.
  double conflict_depth = 0.3;  ///< A wall this deep in the other's free space conflicts, metres.
};

/// Map b, whose frame has the pose `pose_b_in_a` in a's, over map a. Names are for the legend.
[[nodiscard]] cv::Mat drawOverlay(const StateGrid& a, const StateGrid& b, const Pose2D& pose_b_in_a,
                                  const std::string& title, const std::string& name_a,
                                  const std::string& name_b, const OverlayOptions& options = {});

}  // namespace sbox
