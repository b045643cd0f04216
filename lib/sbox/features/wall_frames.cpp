// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/wall_frames.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sbox {
namespace {

constexpr int kBins = 180;  // Half a degree each.
constexpr double kBinWidth = M_PI / 2 / kBins;
using Histogram = std::array<double, kBins>;

size_t wrapped(int bin) { return static_cast<size_t>(((bin % kBins) + kBins) % kBins); }

Histogram directionHistogram(const std::vector<WallLine>& lines, const FrameOptions& options) {
  Histogram raw{};
  for (const WallLine& line : lines) {
    if (line.wall_share < options.min_wall_share) {
      continue;
    }
    const Eigen::Vector2d along = line.to - line.from;
    const double turns = std::atan2(along.y(), along.x()) / kBinWidth;
    raw[wrapped(static_cast<int>(std::floor(turns)))] += along.squaredNorm();
  }
  Histogram smooth{};
  const double sigma = options.smoothing * M_PI / 180 / kBinWidth;
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  for (int offset = -reach; offset <= reach; ++offset) {
    const double weight = std::exp(-0.5 * offset * offset / (sigma * sigma));
    for (int bin = 0; bin < kBins; ++bin) {
      smooth[static_cast<size_t>(bin)] += weight * raw[wrapped(bin + offset)];
    }
  }
  return smooth;
}

/// Place of the peak between bins, from the parabola through it and its neighbours.
double peakDirection(const Histogram& histogram, int bin) {
  const double left = histogram[wrapped(bin - 1)], right = histogram[wrapped(bin + 1)];
  const double middle = histogram[static_cast<size_t>(bin)];
  const double curvature = left - 2 * middle + right;
  const double shift = curvature < 0 ? 0.5 * (left - right) / curvature : 0;
  const double direction = (bin + 0.5 + shift) * kBinWidth;
  return direction >= M_PI / 2 ? direction - M_PI / 2 : std::max(direction, 0.0);
}

}  // namespace

std::vector<WallFrame> findFrames(const std::vector<WallLine>& lines, const FrameOptions& options) {
  const Histogram histogram = directionHistogram(lines, options);
  Histogram open = histogram;
  std::vector<WallFrame> frames;
  while (static_cast<int>(frames.size()) < options.max_frames) {
    const auto peak = std::max_element(open.begin(), open.end());
    const auto bin = static_cast<int>(peak - open.begin());
    // What is left on the flank of a taken frame is no peak of its own.
    const bool is_peak = histogram[wrapped(bin)] >= histogram[wrapped(bin - 1)] &&
                         histogram[wrapped(bin)] >= histogram[wrapped(bin + 1)];
    if (*peak <= 0 || (!frames.empty() && *peak < options.min_share * frames.front().weight)) {
      break;
    }
    if (is_peak) {
      frames.push_back({peakDirection(histogram, bin), *peak});
    }
    const int reach = is_peak ? static_cast<int>(options.separation * M_PI / 180 / kBinWidth) : 0;
    for (int offset = -reach; offset <= reach; ++offset) {
      open[wrapped(bin + offset)] = 0;
    }
  }
  double total = 0;
  for (const WallFrame& frame : frames) {
    total += frame.weight;
  }
  for (WallFrame& frame : frames) {
    frame.weight /= total;
  }
  return frames;
}

}  // namespace sbox
