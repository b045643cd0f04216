// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox/core/state_grid.h"
#include "sbox/report/drawing/plot_view.h"

namespace sbox::html {

/// The cells of one map as two masks, which the page holds once and shows wherever the map appears.
struct MapMasks {
  PlotView view;           ///< The part of the map frame that both show.
  std::string free_class;  ///< CSS class of the mask of free space.
  std::string wall_class;  ///< That of the walls.
  std::string style;       ///< The CSS rules that define the classes.
};

/// `name` starts the names of the classes; the longer side has up to `long_side` pixels.
[[nodiscard]] MapMasks maskMap(const StateGrid& grid, const std::string& name, int long_side);

/// The CSS rule that gives a class this mask (8 bit, one channel).
[[nodiscard]] std::string maskRule(const std::string& css_class, const cv::Mat& mask);

/// Pixels that the longer side of a mask takes when the page shows so many maps: many maps are
/// shown coarser, so that the page does not grow out of hand.
[[nodiscard]] int maskSide(size_t map_count);

}  // namespace sbox::html
