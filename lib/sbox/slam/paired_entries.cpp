// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/paired_entries.h"

#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <memory>
#include <optional>

#include "sbox/slam/planar_movement.h"

namespace sbox {
namespace {

using mrpt::obs::CActionCollection;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CActionRobotMovement3D;
using mrpt::obs::CSensoryFrame;
using mrpt::poses::CPose2D;

/// The movements since the last frame.
class Movements {
 public:
  void add(const CActionCollection::Ptr& actions) {
    if (const auto planar = actions->getBestMovementEstimation()) {
      increment_ += planar->poseChange->getMeanVal();
      model_ = planar->motionModelConfiguration;
      time_ = planar->timestamp;
      original_ = any_ ? nullptr : actions;
      any_ = true;
    } else if (const auto spatial = actions->getActionByClass<CActionRobotMovement3D>()) {
      increment_ += CPose2D(spatial->poseChange.getMeanVal());
      time_ = spatial->timestamp;
      original_ = nullptr;
      any_ = true;
    }
  }
  /// Frames may hold where the wheels say the robot is, instead of actions.
  void add(const mrpt::obs::CObservationOdometry& odometry) {
    if (last_odometry_) {
      increment_ += odometry.odometry - *last_odometry_;
    }
    last_odometry_ = odometry.odometry;
    time_ = odometry.timestamp;
    original_ = nullptr;
    any_ = true;
  }
  [[nodiscard]] bool any() const { return any_; }

  CActionCollection::Ptr take() {
    CActionCollection::Ptr taken = original_;
    if (!taken) {
      taken =
          any_ ? planarMovement(increment_, model_, time_) : std::make_shared<CActionCollection>();
    }
    increment_ = CPose2D();
    original_ = nullptr;
    any_ = false;
    return taken;
  }

 private:
  CPose2D increment_;
  CActionRobotMovement2D::TMotionModelOptions model_;
  mrpt::Clock::time_point time_;
  CActionCollection::Ptr original_;  ///< The log's own object, where one says it all.
  std::optional<CPose2D> last_odometry_;
  bool any_ = false;
};

}  // namespace

ScanLog stepsOfPairs(const mrpt::obs::CRawlog& log) {
  using mrpt::obs::CRawlog;
  ScanLog steps;
  bool has_actions = false;
  for (size_t i = 0; i < log.size(); ++i) {
    has_actions = has_actions || log.getType(i) == CRawlog::etActionCollection;
  }
  Movements movements;
  for (size_t i = 0; i < log.size(); ++i) {
    if (log.getType(i) == CRawlog::etActionCollection) {
      movements.add(log.getAsAction(i));
    } else if (log.getType(i) == CRawlog::etSensoryFrame) {
      const CSensoryFrame::Ptr frame = log.getAsObservations(i);
      const auto odometry = frame->getObservationByClass<mrpt::obs::CObservationOdometry>();
      if (odometry && !has_actions) {
        movements.add(*odometry);
      }
      if (frame->getObservationByClass<mrpt::obs::CObservation2DRangeScan>()) {
        steps.has_odometry = steps.has_odometry || movements.any();
        steps.steps.push_back({movements.take(), frame});
      }
    }
  }
  return steps;
}

}  // namespace sbox
