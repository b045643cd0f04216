// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/verification/same_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbox {

double distanceWhenBent(const MapFeatures& a, const MapFeatures& b, const Fit& left,
                        const Fit& right) {
  constexpr size_t asked = 200;
  const PointMover by_left(left.b_in_a), by_right(right.b_in_a);
  double sum = 0;
  int count = 0;
  for (size_t i = 0; i < std::min(asked, b.wall_points.size()); ++i) {
    const Eigen::Vector2d p = by_left(b.wall_points[i].position);
    const Eigen::Vector2d q = by_right(b.wall_points[i].position);
    if (p.x() < 0 || p.y() < 0 || p.x() > a.width || p.y() > a.height) {
      continue;
    }
    sum += (p + left.drift.at(p) - q - right.drift.at(q)).squaredNorm();
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : std::numeric_limits<double>::infinity();
}

void mergeAnswers(const MapFeatures& a, const MapFeatures& b, std::vector<Fit>& fits,
                  const SameAnswerOptions& options) {
  std::vector<Fit> answers;
  for (Fit& fit : fits) {
    const bool is_new = std::none_of(answers.begin(), answers.end(), [&](const Fit& answer) {
      const double roughness = std::max(answer.drift.roughness(), fit.drift.roughness());
      const double limit = std::max(options.distance, options.drift_share * roughness);
      return distanceWhenBent(a, b, answer, fit) < limit;
    });
    if (is_new) {
      answers.push_back(std::move(fit));
    }
  }
  fits = std::move(answers);
}

}  // namespace sbox
