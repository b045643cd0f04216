// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/vertical_points.h"

#include <cmath>

namespace sbox {
namespace {

bool arePerpendicular(const HoughLine& p, const HoughLine& q, double tolerance) {
  // Normals point either way, so angles count modulo pi.
  return std::abs(std::remainder(p.theta - q.theta - M_PI / 2, M_PI)) <= tolerance + 1e-9;
}

Point2D intersection(const HoughLine& p, const HoughLine& q) {
  const double determinant = std::sin(q.theta - p.theta);
  return {(p.rho * std::sin(q.theta) - q.rho * std::sin(p.theta)) / determinant,
          (q.rho * std::cos(p.theta) - p.rho * std::cos(q.theta)) / determinant};
}

}  // namespace

std::vector<VerticalPoint> findVerticalPoints(const std::vector<HoughLine>& lines,
                                              const VerticalPointOptions& options) {
  std::vector<VerticalPoint> points;
  for (size_t i = 0; i < lines.size(); ++i) {
    for (size_t j = i + 1; j < lines.size(); ++j) {
      if (arePerpendicular(lines[i], lines[j], options.perpendicular_tolerance)) {
        points.push_back(
            {intersection(lines[i], lines[j]), static_cast<int>(i), static_cast<int>(j)});
      }
    }
  }
  return points;
}

}  // namespace sbox
