// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sbox/core/pose.h"
#include "sbox/core/state_grid.h"

namespace sbox {

/// What one side of the picture shows.
struct BoxesOfMap {
  const StateGrid* grid = nullptr;                             ///< Its cells, not owned.
  const std::vector<std::array<Point2D, 4>>* boxes = nullptr;  ///< In the map frame, metres.
  std::string name;                                            ///< For the title above it.
};

/// Two maps side by side, each in its own frame, with the boxes that were matched: partners have
/// one colour and one number. Where many match, some that can be told apart are shown, and the
/// title says so. `matched` holds indices into the boxes of a and of b; throws std::out_of_range
/// beyond them.
[[nodiscard]] cv::Mat drawMatchedBoxes(const BoxesOfMap& a, const BoxesOfMap& b,
                                       const std::vector<std::pair<int, int>>& matched);

}  // namespace sbox
