// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/wall_stretches.h"

#include <algorithm>
#include <cmath>

namespace sbox {
namespace {

/// A line as a point and a direction.
struct Ray {
  Ray(double theta, double distance)
      : normal_x(std::cos(theta)), normal_y(std::sin(theta)), rho(distance) {}
  [[nodiscard]] Point2D at(double along, double across) const {
    return {(rho + across) * normal_x - along * normal_y,
            (rho + across) * normal_y + along * normal_x};
  }
  double normal_x, normal_y, rho;
};

/// The part of the line within [0, width] x [0, height] as positions along it; empty if first >
/// last.
struct Clip {
  double first;
  double last;
};

Clip clipToGrid(const Ray& ray, double width, double height, double margin) {
  Clip clip{-std::hypot(width, height) - margin, std::hypot(width, height) + margin};
  const auto cut = [&](double start, double slope, double limit) {
    if (std::abs(slope) < 1e-12) {
      if (start < -margin || start > limit + margin) {
        clip = {1, 0};
      }
      return;
    }
    const double t1 = (-margin - start) / slope, t2 = (limit + margin - start) / slope;
    clip.first = std::max(clip.first, std::min(t1, t2));
    clip.last = std::min(clip.last, std::max(t1, t2));
  };
  cut(ray.rho * ray.normal_x, -ray.normal_y, width);
  cut(ray.rho * ray.normal_y, ray.normal_x, height);
  return clip;
}

}  // namespace

std::vector<WallStretch> findWallStretches(const StateGrid& grid, double theta, double rho,
                                           const StretchOptions& options) {
  const Ray ray(theta, rho);
  const double cell = grid.resolution;
  const int half_cells = static_cast<int>(options.wall_width / 2 / cell + 1e-9);
  const Clip clip = clipToGrid(ray, grid.width * cell, grid.height * cell, options.wall_width);
  std::vector<WallStretch> stretches;
  WallStretch open;
  const auto close = [&] {
    if (!open.cells.empty() && open.end - open.begin >= options.min_length - 1e-9) {
      stretches.push_back(open);
    }
    open.cells.clear();
  };
  for (double along = clip.first; along <= clip.last; along += cell) {
    for (int k = -half_cells; k <= half_cells; ++k) {
      const Point2D p = ray.at(along, k * cell);
      const int x = static_cast<int>(std::floor(p.x / cell));
      const int y = static_cast<int>(std::floor(p.y / cell));
      if (grid.at(x, y) != CellState::Occupied) {
        continue;
      }
      if (!open.cells.empty() && along - open.end > options.max_gap + cell / 2) {
        close();
      }
      if (open.cells.empty()) {
        open.begin = along - cell / 2;
      }
      open.end = along + cell / 2;
      open.cells.push_back(static_cast<size_t>(y) * static_cast<size_t>(grid.width) +
                           static_cast<size_t>(x));
    }
  }
  close();
  for (WallStretch& stretch : stretches) {
    // Neighbouring samples can fall into one cell.
    std::sort(stretch.cells.begin(), stretch.cells.end());
    stretch.cells.erase(std::unique(stretch.cells.begin(), stretch.cells.end()),
                        stretch.cells.end());
  }
  return stretches;
}

}  // namespace sbox
