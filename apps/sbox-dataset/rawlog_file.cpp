// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/rawlog_file.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <fstream>
#include <iomanip>
#include <stdexcept>

namespace sbox::dataset {

using mrpt::obs::CActionRobotMovement2D;

mrpt::obs::CRawlog rawlogOf(const Run& run) {
  // Spread of a step that SLAM may assume: generous, as odometry slips.
  CActionRobotMovement2D::TMotionModelOptions motion;
  motion.modelSelection = CActionRobotMovement2D::mmGaussian;
  motion.gaussianModel.minStdXY = 0.01F;
  motion.gaussianModel.minStdPHI = 0.005F;
  constexpr double kFirstSecond = 1.0e9, kSecondsPerStep = 0.2;
  mrpt::obs::CRawlog log;
  Pose2D last = run.empty() ? Pose2D() : run.front().pose_in_map;
  double seconds = kFirstSecond;
  for (const RunStep& step : run) {
    const auto time = mrpt::Clock::fromDouble(seconds);
    CActionRobotMovement2D movement;
    movement.timestamp = time;
    movement.computeFromOdometry(mrpt::poses::CPose2D(inverse(last) + step.pose_in_map), motion);
    mrpt::obs::CActionCollection actions;
    actions.insert(movement);
    auto scan = mrpt::obs::CObservation2DRangeScan::Create(step.scan);
    scan->timestamp = time;
    scan->sensorLabel = "LASER";
    mrpt::obs::CSensoryFrame frame;
    frame.insert(scan);
    log.insert(actions);
    log.insert(frame);
    last = step.pose_in_map;
    seconds += kSecondsPerStep;
  }
  return log;
}

void saveRawlog(const Run& run, const std::string& path) {
  if (!rawlogOf(run).saveToRawLogFile(path)) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

void saveTruePoses(const Run& run, const std::string& path) {
  std::ofstream file(path);
  file << std::fixed << std::setprecision(6);
  for (size_t i = 0; i < run.size(); ++i) {
    const Pose2D& pose = run[i].pose_in_world;
    file << i << ' ' << pose.x << ' ' << pose.y << ' ' << pose.phi << '\n';
  }
  if (!file.flush()) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

}  // namespace sbox::dataset
