// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What walls that are far from where they should be count: the loss of Geman and McClure, whose
// scale shrinks from round to round.
#pragma once

#include <cmath>

namespace sbox {

/// What is left of the square of a residual under the loss, as a share of it: 1 near zero, a half
/// at the scale. The weight in reweighted least squares is the square of this.
[[nodiscard]] inline double gemanMcClureShare(double squared_residual, double scale) {
  return scale * scale / (scale * scale + squared_residual);
}

/// The scale of round 0, 1, ...: it goes geometrically from `first` to `last`, which is that of the
/// last round.
[[nodiscard]] inline double scaleOfRound(int round, int rounds, double first, double last) {
  const double share = rounds > 1 ? round / static_cast<double>(rounds - 1) : 1;
  return first * std::pow(last / first, share);
}

}  // namespace sbox
