// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/matching/heading_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sbox {
namespace {

constexpr int kDegrees = 360;  // A bin each.
using DegreeHistogram = std::array<double, kDegrees>;

size_t degreeBin(int bin) { return static_cast<size_t>(((bin % kDegrees) + kDegrees) % kDegrees); }

DegreeHistogram facingHistogram(const MapFeatures& map, double smoothing) {
  DegreeHistogram raw{};
  for (const WallPoint& point : map.wall_points) {
    const double degrees = std::atan2(point.normal.y(), point.normal.x()) * 180 / M_PI;
    raw[degreeBin(static_cast<int>(std::floor(degrees)))] += 1;
  }
  DegreeHistogram smooth{};
  const int reach = static_cast<int>(std::ceil(3 * smoothing));
  for (int offset = -reach; offset <= reach; ++offset) {
    const double weight = std::exp(-0.5 * offset * offset / (smoothing * smoothing));
    for (int bin = 0; bin < kDegrees; ++bin) {
      smooth[static_cast<size_t>(bin)] += weight * raw[degreeBin(bin + offset)];
    }
  }
  return smooth;
}

}  // namespace

std::vector<double> findHeadings(const MapFeatures& a, const MapFeatures& b,
                                 const HeadingOptions& options) {
  const DegreeHistogram facing_a = facingHistogram(a, options.smoothing);
  const DegreeHistogram facing_b = facingHistogram(b, options.smoothing);
  DegreeHistogram correlation{};
  for (int turn = 0; turn < kDegrees; ++turn) {
    for (int bin = 0; bin < kDegrees; ++bin) {
      correlation[static_cast<size_t>(turn)] +=
          facing_a[degreeBin(bin + turn)] * facing_b[static_cast<size_t>(bin)];
    }
  }
  const auto best = static_cast<int>(std::max_element(correlation.begin(), correlation.end()) -
                                     correlation.begin());
  std::vector<std::pair<double, int>> found;
  const int steps = static_cast<int>(std::lround(kDegrees / options.step));
  for (int i = 0; i < steps; ++i) {
    const int turn =
        best + static_cast<int>(std::lround(i * kDegrees / static_cast<double>(steps)));
    const double value = correlation[degreeBin(turn)];
    if (value > 0 && value >= options.min_share * correlation[static_cast<size_t>(best)]) {
      found.emplace_back(-value, static_cast<int>(degreeBin(turn)));
    }
  }
  std::sort(found.begin(), found.end());
  found.resize(std::min(found.size(), static_cast<size_t>(options.max_headings)));
  std::vector<double> headings;
  for (const auto& [value, turn] : found) {
    headings.push_back(turn * M_PI / 180);
  }
  return headings;
}

}  // namespace sbox
