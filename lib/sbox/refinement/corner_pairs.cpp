// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/corner_pairs.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>

namespace sbox {
namespace {

using Corners = std::array<Eigen::Vector2d, 4>;

/// Mean of the two sides that run from corner 0 to 1 and from 3 to 2.
Eigen::Vector2d firstSide(const Corners& c) { return 0.5 * ((c[1] - c[0]) + (c[2] - c[3])); }
/// Mean of the two sides across.
Eigen::Vector2d secondSide(const Corners& c) { return 0.5 * ((c[3] - c[0]) + (c[2] - c[1])); }

/// Eq. 12, squared and turned into the axes of map a by the angle of the box there (figure 9).
Eigen::Matrix2d sideMismatch(const BoxMatch& match, double corner_noise) {
  const Eigen::Vector2d side = firstSide(match.corners_a);
  const double half_first = 0.5 * (side.norm() - firstSide(match.corners_b).norm());
  const double half_second =
      0.5 * (secondSide(match.corners_a).norm() - secondSide(match.corners_b).norm());
  const double floor = corner_noise * corner_noise;
  const Eigen::Vector2d variances(half_first * half_first + floor,
                                  half_second * half_second + floor);
  const Eigen::Matrix2d turn =
      Eigen::Rotation2Dd(std::atan2(side.y(), side.x())).toRotationMatrix();
  return turn * variances.asDiagonal() * turn.transpose();
}

}  // namespace

std::vector<CornerPair> uniqueCorners(const std::vector<BoxMatch>& matches, double corner_noise) {
  std::vector<CornerPair> pairs;
  std::vector<int> boxes;
  // Boxes that share two lines have the very same corner there, up to rounding.
  std::map<std::array<long, 4>, size_t> index_of;
  const auto millimetres = [](double metres) { return std::lround(metres * 1000); };
  for (const BoxMatch& match : matches) {
    const Eigen::Matrix2d covariance = sideMismatch(match, corner_noise);
    for (size_t i = 0; i < 4; ++i) {
      const Eigen::Vector2d& a = match.corners_a[i];
      const Eigen::Vector2d& b = match.corners_b[i];
      const auto [place, is_new] = index_of.try_emplace(
          {millimetres(a.x()), millimetres(a.y()), millimetres(b.x()), millimetres(b.y())},
          pairs.size());
      if (is_new) {
        pairs.push_back({a, b, covariance});
        boxes.push_back(1);
      } else {
        pairs[place->second].covariance += covariance;
        ++boxes[place->second];
      }
    }
  }
  for (size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].covariance /= boxes[i];
  }
  return pairs;
}

}  // namespace sbox
