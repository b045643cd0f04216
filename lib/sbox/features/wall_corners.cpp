// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/wall_corners.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/sort_descending.h"

namespace sbox {
namespace {

double distanceTo(const AxisLine& line, double along) {
  return std::max({0.0, line.low - along, along - line.high});
}

/// The arms of a line that passes `along`: bit `up` towards larger coordinates, `down` to smaller.
QuarterMask armsOf(const AxisLine& line, double along, Quarter up, Quarter down, double min_arm) {
  const int has_up = line.high - along >= min_arm ? 1 << up : 0;
  const int has_down = along - line.low >= min_arm ? 1 << down : 0;
  return static_cast<QuarterMask>(has_up | has_down);
}

double longestArm(const AxisLine& line, double along) {
  return std::min(std::max(line.high - along, along - line.low), line.high - line.low);
}

}  // namespace

QuarterMask turned(QuarterMask mask, int turns) {
  const int by = ((turns % 4) + 4) % 4;
  return static_cast<QuarterMask>(((mask << by) | (mask >> (4 - by))) & 0xF);
}

Eigen::Vector2d crossing(const AxisLine& along_x, const AxisLine& along_y) {
  // y = y0 + m (x - xm), x = x0 + k (y - ym).
  const double xm = 0.5 * (along_x.low + along_x.high), ym = 0.5 * (along_y.low + along_y.high);
  const double m = along_x.slope, k = along_y.slope;
  const double x = (along_y.across + k * (along_x.across - m * xm - ym)) / (1 - k * m);
  return {x, along_x.acrossAt(x)};
}

std::vector<WallCorner> findCorners(const AxisLines& lines, const CornerOptions& options) {
  std::vector<WallCorner> corners;
  for (const Quarter side_y : {1, 3}) {
    const std::vector<AxisLine>& along_x = lines[static_cast<size_t>(side_y)];
    // How far a tilted line may be off its middle where it ends, and as far beyond as a corner may.
    double most_off = 0;
    for (const AxisLine& line : along_x) {
      const double half = (line.high - line.low) / 2 + options.reach;
      most_off = std::max(most_off, std::abs(line.slope) * half);
    }
    const double slack = options.reach + most_off;
    for (const Quarter side_x : {0, 2}) {
      for (const AxisLine& vertical : lines[static_cast<size_t>(side_x)]) {
        // Lines along x are sorted by y: only those within the reach of this one's ends.
        auto horizontal = std::lower_bound(
            along_x.begin(), along_x.end(), vertical.low - slack,
            [](const AxisLine& line, double value) { return line.across < value; });
        for (; horizontal != along_x.end() && horizontal->across <= vertical.high + slack;
             ++horizontal) {
          const Eigen::Vector2d point = crossing(*horizontal, vertical);
          if (distanceTo(*horizontal, point.x()) > options.reach ||
              distanceTo(vertical, point.y()) > options.reach) {
            continue;
          }
          WallCorner corner;
          corner.position = point;
          corner.free_sides = static_cast<QuarterMask>((1 << side_x) | (1 << side_y));
          corner.arms =
              static_cast<QuarterMask>(armsOf(*horizontal, point.x(), 0, 2, options.min_arm) |
                                       armsOf(vertical, point.y(), 1, 3, options.min_arm));
          corner.strength =
              std::min(longestArm(*horizontal, point.x()), longestArm(vertical, point.y()));
          corners.push_back(corner);
        }
      }
    }
  }
  if (static_cast<int>(corners.size()) > options.max_corners) {
    sortDescending(corners, [](const WallCorner& corner) { return corner.strength; });
    corners.resize(static_cast<size_t>(options.max_corners));
  }
  return corners;
}

}  // namespace sbox
