// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "adjustment/pose_error.h"
#include "mapping/scanned_room.h"
#include "sbox/fusion/join_key_frames.h"

namespace sbox::test {

/// Two robots that drive round one hall; the heading of each drifts its own way, and the map of the
/// second is placed a little wrong.
struct DriftedRobots {
  Room hall{-6.02, 6.03, -4.01, 4.04};
  KeyFrames of_a, of_b;
  std::vector<Pose2D> truth;  ///< Of all key frames, in the frame of a.
  Pose2D pose_b_in_a;         ///< As placed.

  explicit DriftedRobots(double drift = 0.006, const Pose2D& misplaced = {0.1, -0.08, 0.02}) {
    const std::vector<Pose2D> path_a = drive(0, 1), path_b = drive(2.5, -1);
    of_a = keyFrames(path_a, drift);
    of_b = keyFrames(path_b, -drift);
    for (const std::vector<Pose2D>* path : {&path_a, &path_b}) {
      for (const Pose2D& in_hall : *path) {
        truth.push_back(inverse(path_a.front()) + in_hall);
      }
    }
    pose_b_in_a = inverse(path_a.front()) + path_b.front() + misplaced;
  }

  [[nodiscard]] std::vector<PlacedKeyFrames> placed() const {
    return {{&of_a, {}}, {&of_b, pose_b_in_a}};
  }

  /// Of all key frames from the truth, after the best rigid fit; metres.
  [[nodiscard]] double error(const KeyFrames& frames) const {
    std::vector<Pose2D> poses;
    for (const KeyFrame& frame : frames) {
      poses.push_back(poseOf(frame));
    }
    return poseError(poses, truth);
  }

 private:
  /// Once round an ellipse in the hall, from `from` on, in the direction of `side`.
  static std::vector<Pose2D> drive(double from, double side) {
    constexpr int count = 40;
    std::vector<Pose2D> path;
    for (int i = 0; i < count; ++i) {
      const double turn = from + side * 2 * M_PI * i / count;
      path.emplace_back(4 * std::cos(turn), 2.5 * std::sin(turn),
                        std::atan2(side * 2.5 * std::cos(turn), -side * 4 * std::sin(turn)));
    }
    return path;
  }

  /// In the frame of the first, each heading off by `drift` more.
  [[nodiscard]] KeyFrames keyFrames(const std::vector<Pose2D>& path, double drift) const {
    KeyFrames frames;
    Pose2D in_map;
    for (size_t i = 0; i < path.size(); ++i) {
      if (i > 0) {
        in_map = in_map + (inverse(path[i - 1]) + path[i]) + Pose2D(0, 0, drift);
      }
      frames.push_back(keyFrame(hall, path[i], in_map));
    }
    return frames;
  }
};

}  // namespace sbox::test
