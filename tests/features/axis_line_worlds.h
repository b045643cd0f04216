// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Axis lines of a known room, and random ones.
#pragma once

#include <algorithm>
#include <random>

#include "sbox/features/axis_lines.h"

namespace sbox::test {

/// The walls of the room [1, 7] x [2, 5], seen from inside.
inline AxisLines roomAxisLines() {
  AxisLines lines;
  lines[0] = {{2, 5, 1, 0, 1}};
  lines[1] = {{1, 7, 2, 0, 1}};
  lines[2] = {{2, 5, 7, 0, 1}};
  lines[3] = {{1, 7, 5, 0, 1}};
  return lines;
}

/// `count` lines facing each way within 30 m x 30 m, off their axis by up to `slope`.
inline AxisLines randomAxisLines(int count, double slope, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 24), length(0.5, 10), tilt(-slope, slope);
  AxisLines lines;
  for (std::vector<AxisLine>& side : lines) {
    for (int i = 0; i < count; ++i) {
      const double low = place(random);
      side.push_back({low, low + length(random), place(random), tilt(random), 1});
    }
    std::sort(side.begin(), side.end(),
              [](const AxisLine& a, const AxisLine& b) { return a.across < b.across; });
  }
  return lines;
}

/// The same lines in a frame that is a quarter turn further back: all things come out turned by
/// one quarter counter-clockwise.
inline AxisLines quarterTurned(const AxisLines& lines) {
  AxisLines result;
  for (size_t side = 0; side < 4; ++side) {
    for (const AxisLine& line : lines[side]) {
      // (x, y) becomes (-y, x). Lines facing along x run along y and come to run along -x.
      const bool runs_along_y = side % 2 == 0;
      result[(side + 1) % 4].push_back(
          runs_along_y ? AxisLine{-line.high, -line.low, line.across, -line.slope, line.wall_share}
                       : AxisLine{line.low, line.high, -line.across, -line.slope, line.wall_share});
    }
  }
  for (std::vector<AxisLine>& side : result) {
    std::sort(side.begin(), side.end(),
              [](const AxisLine& a, const AxisLine& b) { return a.across < b.across; });
  }
  return result;
}

}  // namespace sbox::test
