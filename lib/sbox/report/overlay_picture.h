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
#include "sbox/report/overlay_layers.h"

namespace sbox {

/// Map b, whose frame has the pose `pose_b_in_a` in a's, over map a. Names are for the legend.
[[nodiscard]] cv::Mat drawOverlay(const StateGrid& a, const StateGrid& b, const Pose2D& pose_b_in_a,
                                  const std::string& title, const std::string& name_a,
                                  const std::string& name_b, const OverlayOptions& options = {});

}  // namespace sbox
