// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sbox/core/pose.h"
#include "sbox/core/state_grid.h"

namespace sbox::bench {

/// Centres of the occupied cells, seen from the lower-left corner of the grid, in metres.
[[nodiscard]] std::vector<Point2D> wallPoints(const StateGrid& grid);

/// Hough spectrum (Carpin 2008, section 4): for each of `bins` directions of a line's normal,
/// evenly over [0, pi), the sum over rho of the squared Hough transform of the points; rho in steps
/// of `rho_step` metres. Peaks where walls are long and straight.
[[nodiscard]] std::vector<double> houghSpectrum(const std::vector<Point2D>& points, int bins,
                                                double rho_step);

/// The direction in [0, pi/2) along whose axes the spectrum, folded by quarter turns, is largest,
/// in radians. `spectrum` must have an even number of bins.
[[nodiscard]] double dominantDirection(const std::vector<double>& spectrum);

}  // namespace sbox::bench
