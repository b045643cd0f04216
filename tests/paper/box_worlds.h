// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random sets of boxes with a known transform between them.
#pragma once

#include <random>
#include <vector>

#include "sbox/paper/boxes.h"
#include "sbox/paper/transform.h"

namespace sbox::test {

/// Boxes of 1 to 8 m sides, parallel to the axes, within 30 m x 30 m.
inline std::vector<SuppositionalBox> randomBoxes(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 22), side(1, 8);
  std::vector<SuppositionalBox> boxes;
  for (int i = 0; i < count; ++i) {
    const Point2D low(place(random), place(random));
    const Point2D high(low.x + side(random), low.y + side(random));
    boxes.push_back(describeBox({low, {high.x, low.y}, high, {low.x, high.y}}));
  }
  return boxes;
}

/// The boxes as another map holds them whose frame sees this one's at `pose`, corners off by up to
/// `noise` metres.
inline std::vector<SuppositionalBox> moved(const std::vector<SuppositionalBox>& boxes,
                                           const Pose2D& pose, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-noise, noise);
  const Transform transform(pose);
  std::vector<SuppositionalBox> result;
  for (const SuppositionalBox& box : boxes) {
    std::array<Point2D, 4> corners;
    for (size_t i = 0; i < 4; ++i) {
      corners[i] = transform(box.corners[i]) + Point2D(off(random), off(random));
    }
    result.push_back(describeBox(corners));
  }
  return result;
}

}  // namespace sbox::test
