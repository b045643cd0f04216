// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sbox/core/pose.h"

namespace sbox::html {

/// "1.234 m" and how sure it is, for x, y and phi: three table cells with one standard deviation
/// each.
[[nodiscard]] std::string poseCells(const Pose2D& pose, const PoseCovariance& covariance);

/// A pose with its standard deviations, and its covariance to be opened below.
[[nodiscard]] std::string poseTable(const Pose2D& pose, const PoseCovariance& covariance);

/// "0.012 m and 0.03 deg apart".
[[nodiscard]] std::string differenceText(const Pose2D& pose, const Pose2D& other);

}  // namespace sbox::html
