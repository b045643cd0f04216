// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Straight lines of a map by the Hough transform (paper, section 3.1.1). The normal form
// x cos(theta) + y sin(theta) = rho stands in for slope and intercept: it knows vertical lines.
// Lines are taken strongest first, and a line takes the votes of its wall with it: otherwise the
// echoes of the longest walls outvote all the short ones. What is left of a bent or thick wall
// still gives the several nearly equal lines that the paper speaks of.
#pragma once

#include <vector>

#include "sbox/paper/wall_stretches.h"

namespace sbox {

/// Bins of the transform, and what makes a line.
struct HoughOptions {
  double theta_step = M_PI / 180;  ///< Width of an angle bin, radians.
  double rho_step = 0.05;          ///< Width of a distance bin, metres; at least one cell.
  int max_lines = 80;              ///< The strongest are kept.
  StretchOptions stretches;        ///< What a line needs: one such stretch, and votes to fill it.
};

/// A line in the grid frame: metres from the lower-left corner of the grid, x along its rows.
struct HoughLine {
  double theta = 0;  ///< Direction of the normal, radians in [0, pi).
  double rho = 0;    ///< Signed distance of the grid frame's origin along the normal, metres.
  int votes = 0;     ///< Occupied cells on it that no stronger line has taken.
  Point2D from;      ///< Begin of its first stretch of wall and
  Point2D to;        ///< end of its last.
};

/// The lines on which enough occupied cells lie, strongest first. Throws std::invalid_argument if a
/// step is not positive.
[[nodiscard]] std::vector<HoughLine> findHoughLines(const StateGrid& grid,
                                                    const HoughOptions& options = {});

}  // namespace sbox
