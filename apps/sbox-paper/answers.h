// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The transforms that are compared: the paper's before and after its Kalman step, and ours.
#pragma once

#include <optional>
#include <string>

#include "sbox-bench/method.h"
#include "sbox/core/map.h"
#include "sbox/core/pair_result.h"

namespace sbox::paper {

/// The default method of the library, by the name that the benchmark knows it by.
[[nodiscard]] bench::Method defaultMethod();

/// A method's answer for two maps.
[[nodiscard]] PairResult solve(const bench::Method& method, const Map& a, const Map& b);

/// The "violent merge" of figure 8: the pose of b in a from three corners of the paper's best pair
/// of boxes, before any Kalman step. None if there is no such pair.
[[nodiscard]] std::optional<Pose2D> plainPaperPose(const Map& a, const Map& b);

/// Maps a and b in a's frame, fused by the library's default rule.
[[nodiscard]] Map mergeTwo(const Map& a, const Map& b, const Pose2D& pose_b_in_a);

/// The map turned about its frame's origin, where the robot started, by an angle in radians and
/// written into upright cells again, as the paper does (figures 9 to 11): its walls grow jagged.
[[nodiscard]] Map turnedMap(const Map& map, double angle);

}  // namespace sbox::paper
