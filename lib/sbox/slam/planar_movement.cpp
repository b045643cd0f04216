// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/planar_movement.h"

#include <memory>

namespace sbox {

mrpt::obs::CActionCollection::Ptr planarMovement(
    const mrpt::poses::CPose2D& increment,
    const mrpt::obs::CActionRobotMovement2D::TMotionModelOptions& model,
    mrpt::Clock::time_point time) {
  mrpt::obs::CActionRobotMovement2D moved;
  moved.computeFromOdometry(increment, model);
  moved.timestamp = time;
  auto actions = std::make_shared<mrpt::obs::CActionCollection>();
  actions->insert(moved);
  return actions;
}

}  // namespace sbox
