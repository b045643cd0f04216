// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The corners of all agreeing boxes, each once, with what the boxes say of their accuracy.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sbox/matching/matched_boxes.h"

namespace sbox {

/// A corner of map a and the corner of map b that lies on it.
struct CornerPair {
  Eigen::Vector2d in_a;  ///< Grid frame of map a, metres.
  Eigen::Vector2d in_b;  ///< Grid frame of map b, metres.
  /// R of eq. 12, of the offset between the two, in the axes of map a, square metres.
  Eigen::Matrix2d covariance;
};

/// The unique corner pairs, in the order in which the matches name them. Covariance: half of the
/// difference of the boxes' sides along each axis of the box (eq. 12), squared, the mean over all
/// boxes that share the corner, with a floor of `corner_noise` (metres), turned into map a's axes.
[[nodiscard]] std::vector<CornerPair> uniqueCorners(const std::vector<BoxMatch>& matches,
                                                    double corner_noise);

}  // namespace sbox
