// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/adjusted_pair.h"

#include "sbox/adjustment/adjust_key_frames.h"

namespace sbox::paper {

RobotPair adjustedPair(const RobotPair& pair, const Pose2D& pose_b_in_a) {
  const KeyFrames of_1 = keyFramesOf(pair.runs[0]), of_2 = keyFramesOf(pair.runs[1]);
  const KeyFrames adjusted =
      adjustKeyFrames({{&of_1, Pose2D()}, {&of_2, pose_b_in_a}}, 0, {}, /*threads=*/1);
  RobotPair result = pair;
  result.truth.reset();
  auto key_frame = adjusted.begin();
  for (size_t i = 0; i < 2; ++i) {
    for (dataset::RunStep& step : result.runs[i]) {
      mrpt::poses::CPose3D pose;
      key_frame->robot_in_map->getMean(pose);
      step.pose_in_map = {pose.x(), pose.y(), pose.yaw()};
      ++key_frame;
    }
    result.maps[i] = mapRun(pair.maps[i].name, result.runs[i]);
  }
  return result;
}

Map mapOfBoth(const RobotPair& adjusted) {
  dataset::Run both = adjusted.runs[0];
  both.insert(both.end(), adjusted.runs[1].begin(), adjusted.runs[1].end());
  return mapRun(adjusted.name, both);
}

}  // namespace sbox::paper
