// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sbox/core/pose.h"

namespace sbox {

/// The rigid transform that takes `from[i]` closest to `to[i]`, by least squares: pose of the frame
/// of `from` in that of `to`; of a single point, the shift. Always a rotation, never a mirror
/// image. Throws std::invalid_argument on lists that are empty or of unequal length.
[[nodiscard]] Pose2D fitRigid(const std::vector<Point2D>& from, const std::vector<Point2D>& to);

}  // namespace sbox
