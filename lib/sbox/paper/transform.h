// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The transformation matrix T of the paper, eq. 4; core/rigid_fit gets it from corresponding
// points.
#pragma once

#include <cmath>

#include "sbox/core/pose.h"

namespace sbox {

/// A pose with its sine and cosine worked out once, to carry over many points.
struct Transform {
  /// From the pose of a frame.
  explicit Transform(const Pose2D& pose)
      : x(pose.x), y(pose.y), cosine(std::cos(pose.phi)), sine(std::sin(pose.phi)) {}

  /// The point, given in the posed frame, in the frame that the pose is in.
  [[nodiscard]] Point2D operator()(const Point2D& p) const {
    return {cosine * p.x - sine * p.y + x, sine * p.x + cosine * p.y + y};
  }

  double x;       ///< Of the pose, metres.
  double y;       ///< Of the pose, metres.
  double cosine;  ///< Of its angle.
  double sine;    ///< Of its angle.
};

}  // namespace sbox
