// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/fusion/cell_warp.h"

#include <algorithm>
#include <cmath>

namespace sbox {
namespace {

std::int64_t toFixed(double cells) {
  return std::llround(cells * static_cast<double>(kSubCellUnit));
}

std::int64_t ceilDiv(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return quotient + ((a % b != 0 && (a < 0) == (b < 0)) ? 1 : 0);
}

/// Cuts [first, end) down to the x with low <= start + x step < high.
void clip(std::int64_t start, std::int64_t step, std::int64_t low, std::int64_t high,
          std::int64_t* first, std::int64_t* end) {
  if (step == 0) {
    if (start < low || start >= high) {
      *end = *first;
    }
    return;
  }
  // Walking backwards, the bounds swap and the open end moves to the other side.
  const std::int64_t from = step > 0 ? low : high - 1;
  const std::int64_t to = step > 0 ? high : low - 1;
  *first = std::max(*first, ceilDiv(from - start, step));
  *end = std::min(*end, ceilDiv(to - start, step));
}

}  // namespace

CellWarp::CellWarp(const Pose2D& grid_in_lattice, double map_resolution,
                   double lattice_resolution) {
  const double ratio = lattice_resolution / map_resolution;
  const double c = std::cos(grid_in_lattice.phi), s = std::sin(grid_in_lattice.phi);
  step_x_ = {toFixed(ratio * c), toFixed(-ratio * s)};
  step_y_ = {toFixed(ratio * s), toFixed(ratio * c)};
  const double x = 0.5 * lattice_resolution - grid_in_lattice.x;
  const double y = 0.5 * lattice_resolution - grid_in_lattice.y;
  origin_ = {toFixed((c * x + s * y) / map_resolution - 0.5),
             toFixed((c * y - s * x) / map_resolution - 0.5)};
}

CellSpan CellWarp::spanWithin(const CellSpan& row, int y, const SubCell& low,
                              const SubCell& high) const {
  const SubCell start = at(0, y);
  std::int64_t first = row.first, end = row.end;
  clip(start.u, step_x_.u, low.u, high.u, &first, &end);
  clip(start.v, step_x_.v, low.v, high.v, &first, &end);
  if (end <= first) {
    return {row.first, row.first};
  }
  return {static_cast<int>(first), static_cast<int>(end)};
}

}  // namespace sbox
