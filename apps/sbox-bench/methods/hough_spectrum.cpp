// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/methods/hough_spectrum.h"

#include <algorithm>
#include <cmath>

namespace sbox::bench {

std::vector<Point2D> wallPoints(const StateGrid& grid) {
  std::vector<Point2D> points;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (grid.at(x, y) == CellState::Occupied) {
        points.emplace_back((x + 0.5) * grid.resolution, (y + 0.5) * grid.resolution);
      }
    }
  }
  return points;
}

std::vector<double> houghSpectrum(const std::vector<Point2D>& points, int bins, double rho_step) {
  std::vector<double> spectrum(static_cast<size_t>(bins), 0.0);
  double reach = 0;
  for (const Point2D& point : points) {
    reach = std::max(reach, std::hypot(point.x, point.y));
  }
  const int offset = static_cast<int>(std::ceil(reach / rho_step)) + 1;
  std::vector<int> transform(static_cast<size_t>(2 * offset + 1));
  for (int bin = 0; bin < bins; ++bin) {
    const double angle = M_PI * bin / bins;
    const double c = std::cos(angle) / rho_step, s = std::sin(angle) / rho_step;
    std::fill(transform.begin(), transform.end(), 0);
    for (const Point2D& point : points) {
      ++transform[static_cast<size_t>(std::lround(point.x * c + point.y * s) + offset)];
    }
    double sum = 0;
    for (const int count : transform) {
      sum += static_cast<double>(count) * count;
    }
    spectrum[static_cast<size_t>(bin)] = sum;
  }
  return spectrum;
}

double dominantDirection(const std::vector<double>& spectrum) {
  const size_t quarter = spectrum.size() / 2;
  size_t best = 0;
  for (size_t i = 1; i < quarter; ++i) {
    if (spectrum[i] + spectrum[i + quarter] > spectrum[best] + spectrum[best + quarter]) {
      best = i;
    }
  }
  return M_PI * static_cast<double>(best) / static_cast<double>(spectrum.size());
}

}  // namespace sbox::bench
