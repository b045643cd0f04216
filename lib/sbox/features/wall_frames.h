// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The directions in which most walls run. A building may have several, one a wing.
#pragma once

#include <vector>

#include "sbox/features/wall_lines.h"

namespace sbox {

/// Which directions make a frame.
struct FrameOptions {
  double min_wall_share = 0.5;  ///< Of lines that count: the edge of the unknown has no direction.
  double smoothing = 2.0;       ///< Standard deviation of the direction histogram, degrees.
  double separation = 12.0;     ///< Between two frames, degrees.
  double min_share = 0.2;       ///< A further frame's peak over the highest.
  int max_frames = 3;           ///< The strongest are kept.
};

/// A direction in which walls run, they or their perpendiculars, and how much speaks for it.
struct WallFrame {
  double direction = 0;  ///< In the grid frame, radians in [0, pi/2).
  double weight = 0;     ///< Peak of the histogram of squared lengths, over that of all frames.
};

/// Frames from a histogram of line directions modulo 90 degrees, weighted by squared length; the
/// strongest first. None without lines.
[[nodiscard]] std::vector<WallFrame> findFrames(const std::vector<WallLine>& lines,
                                                const FrameOptions& options = {});

}  // namespace sbox
