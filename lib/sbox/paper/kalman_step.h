// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The Kalman step (paper, section 3.3, eqs. 6 to 14), with its misprints put right:
// - eq. 8 sums signed deviations, which is always zero; here the mean of their squares;
// - eq. 10, lost in print, is x'' = x_c2 + x' - x_c1', as eq. 11 is for y;
// - eq. 12 holds lengths along the box's sides; here they are squared and turned into map axes;
// - eq. 13 carries P through T once more, though it already is in map b's frame; here it is not.
#pragma once

#include <array>
#include <vector>

#include "sbox/core/state_grid.h"
#include "sbox/paper/boxes.h"
#include "sbox/paper/transform.h"

namespace sbox {

/// Two matched boxes: corner i of `corners_a` corresponds to corner i of `corners_b`. Grid frames.
struct MatchedBoxes {
  std::array<Point2D, 4> corners_a;  ///< Of the box in map a, metres in its grid frame.
  std::array<Point2D, 4> corners_b;  ///< Their counterparts in map b.
};

/// Box a and box b with b's corners brought into correspondence by the shift.
[[nodiscard]] MatchedBoxes matchedBoxes(const SuppositionalBox& box_a,
                                        const SuppositionalBox& box_b, int shift);

/// What the step says of one point of map a, in map b.
struct KalmanEstimate {
  Eigen::Vector2d prediction;              ///< X^, eq. 6.
  Eigen::Vector2d observation;             ///< Z, eqs. 9 to 11.
  Eigen::Matrix2d prediction_covariance;   ///< P, eqs. 7 and 8.
  Eigen::Matrix2d observation_covariance;  ///< R, eq. 12.
  Eigen::Matrix2d gain;                    ///< K, eq. 13: the weight of the prediction.
  Eigen::Vector2d estimate;                ///< X', eq. 14, not yet rounded to a cell.
  Eigen::Matrix2d covariance;              ///< Of the estimate.
};

/// The filter for one pair of boxes.
class KalmanStep {
 public:
  /// `pose_a_in_b` is the transform T that the boxes proposed.
  KalmanStep(const MatchedBoxes& boxes, const Pose2D& pose_a_in_b);

  /// The estimate for a point of map a, in metres.
  [[nodiscard]] KalmanEstimate at(const Point2D& point_in_a) const;

  /// Centre of box a.
  [[nodiscard]] const Point2D& centreInA() const { return centre_a_; }
  /// Ta to Td, each without one of the four corner pairs, as poses of a in b.
  [[nodiscard]] const std::array<Pose2D, 4>& poses() const { return poses_; }

 private:
  Transform prediction_;
  std::array<Pose2D, 4> poses_;
  std::vector<Transform> transforms_;
  Point2D centre_a_;
  Eigen::Vector2d shift_;  ///< Z - X^ = c2 - T c1, the same everywhere.
  Eigen::Matrix2d observation_covariance_;
};

/// The step for a whole map, summed up.
struct KalmanResult {
  Pose2D pose_a_in_b;         ///< The rigid transform nearest to the field of rounded estimates.
  PoseCovariance covariance;  ///< Of pose_a_in_b; never zero.
};

/// Runs the step for each known cell of map a, rounds its estimate to a cell of map b, and fits a
/// rigid transform to all of them. The covariance joins that of the estimate at the box's centre,
/// the spread of the headings of Ta to Td and the rounding; as it knows of one pair of boxes only,
/// it is too small where maps are bent.
[[nodiscard]] KalmanResult refineByKalman(const StateGrid& grid_a, const StateGrid& grid_b,
                                          const MatchedBoxes& boxes, const Pose2D& pose_a_in_b);

}  // namespace sbox
