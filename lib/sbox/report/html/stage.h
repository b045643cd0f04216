// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stage: a window of the page that shows part of the plane, at any size. What lies on it is
// placed in metres; the page scales and turns it.
#pragma once

#include <string>

#include "sbox/core/pose.h"
#include "sbox/report/drawing/plot_view.h"

namespace sbox::html {

/// A layer in one flat colour, painted through a mask.
struct MaskLayer {
  std::string mask;    ///< The CSS class that holds the mask.
  std::string colour;  ///< The CSS class that says in what colour.
  std::string name;    ///< What a checkbox of the viewer calls it.
};

/// The layer with its mask over the whole stage.
[[nodiscard]] std::string wholeLayer(const MaskLayer& layer);

/// The layer with its mask, which shows `part` of a map's frame, where that frame has the pose
/// `pose_in_stage`.
[[nodiscard]] std::string placedLayer(const MaskLayer& layer, const PlotView& part,
                                      const Pose2D& pose_in_stage, const PlotView& stage);

/// A stage with these layers, the lowest first, and a scale bar.
[[nodiscard]] std::string stageOf(const PlotView& stage, const std::string& layers);

/// A box that shows and hides the layers of that name in its viewer.
[[nodiscard]] std::string checkbox(const std::string& layer, const std::string& swatch,
                                   const std::string& label, bool checked);

/// Buttons that make the viewer's stages larger and smaller.
[[nodiscard]] std::string zoomButtons();

}  // namespace sbox::html
