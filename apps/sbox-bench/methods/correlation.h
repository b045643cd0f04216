// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Brute force: both maps' dominant wall direction gives the rotation up to quarter turns; for each
// of them and a few angles around, walls and free space are correlated by Fourier transform over
// every translation. Finds nearly every whole map but costs some 0.3 s a pair and never refuses.
#pragma once

#include "sbox-bench/method.h"

namespace sbox::bench {

struct CorrelationOptions {
  double resolution = 0.2;       ///< Cell size of the correlation, metres.
  int direction_bins = 360;      ///< Wall directions tried over a half turn; even.
  int fine_angles = 2;           ///< Angles on each side of a quarter turn.
  double fine_step = 0.0174533;  ///< Between those angles, radians.
  double wall_blur = 0.3;        ///< Standard deviation by which walls are widened, metres.
  double free_weight = 0.2;      ///< A free cell counts -this, a wall cell +1.
};

[[nodiscard]] Method correlationMethod(const CorrelationOptions& options = {});

}  // namespace sbox::bench
