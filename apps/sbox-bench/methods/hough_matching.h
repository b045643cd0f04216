// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Map merging by Hough spectra: S. Carpin, "Fast and accurate map merging for multi-robot systems",
// Autonomous Robots 25(3), 2008. Rotations are peaks of the circular cross-correlation of the two
// Hough spectra, each also turned by pi; the translation of each is where the projections of the
// walls on the x and the y axis (X- and Y-spectrum) correlate best; the acceptance index chooses.
// Projections mix up rooms that lie in one row, so it is quick but easily a room off.
#pragma once

#include "sbox-bench/method.h"

namespace sbox::bench {

struct HoughOptions {
  double resolution = 0.1;    ///< Cell size of spectra and acceptance index, metres.
  int direction_bins = 360;   ///< Of the spectrum over a half turn; even.
  int rotations = 4;          ///< Peaks of the circular correlation that are tried.
  int shifts = 3;             ///< Peaks tried on each axis; the paper takes one.
  double least_share = 0.3;   ///< Of the smaller map's known cells, that both must know: the index
                              ///< of a sliver is 1. Not in the paper.
  double accept_index = 0.9;  ///< Acceptance index from which the answer is accepted.
};

[[nodiscard]] Method houghMethod(const HoughOptions& options = {});

}  // namespace sbox::bench
