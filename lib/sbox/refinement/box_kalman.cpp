// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/box_kalman.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace sbox {
namespace {

using Jacobian = Eigen::Matrix<double, 2, 3>;
using Cross = Eigen::Matrix<double, 3, 2>;

/// The filter's state (x, y, heading): the pivot's place in map a.
class CornerFilter {
 public:
  CornerFilter(const RigidTransform& prediction, const Eigen::Vector2d& pivot_b,
               const BoxKalmanOptions& options)
      : pivot_b_(pivot_b) {
    const Eigen::Vector2d place = prediction * pivot_b;
    state_ << place, prediction.heading;
    // Eqs. 7 and 8: P, about the pivot, where shift and turn are independent.
    const double turn = options.prediction_turn * M_PI / 180;
    const double shift = options.prediction_shift;
    covariance_ = Eigen::Vector3d(shift * shift, shift * shift, turn * turn).asDiagonal();
  }

  /// Whether the corner passed the gate and was taken in.
  bool observe(const CornerPair& corner, double gate) {
    const Eigen::Vector2d arm = Eigen::Rotation2Dd(state_.z()) * (corner.in_b - pivot_b_);
    // Eq. 9: Z - X^, where X^ = R(heading) (corner - pivot) + place (eq. 6).
    const Eigen::Vector2d innovation = corner.in_a - (arm + state_.head<2>());
    Jacobian jacobian;
    jacobian << 1, 0, -arm.y(),  //
        0, 1, arm.x();
    const Cross cross = covariance_ * jacobian.transpose();
    const Eigen::Matrix2d spread = jacobian * cross + corner.covariance;
    const Eigen::Matrix2d inverse_spread = spread.inverse();
    if (innovation.dot(inverse_spread * innovation) > gate) {
      return false;
    }
    // Eq. 13 by the usual gain G = P H^T (H P H^T + R)^-1, which is one minus the paper's K.
    const Cross gain = cross * inverse_spread;
    // Eq. 14: X' = X^ + G (Z - X^).
    state_ += gain * innovation;
    // P' = P - G H P.
    covariance_ -= gain * cross.transpose();
    return true;
  }

  [[nodiscard]] RigidTransform transform() const {
    RigidTransform b_in_a;
    b_in_a.heading = state_.z();
    b_in_a.translation = state_.head<2>() - Eigen::Rotation2Dd(state_.z()) * pivot_b_;
    return b_in_a;
  }
  [[nodiscard]] const Eigen::Matrix3d& covariance() const { return covariance_; }

 private:
  Eigen::Vector2d pivot_b_;
  Eigen::Vector3d state_;
  Eigen::Matrix3d covariance_;
};

}  // namespace

std::optional<BoxKalmanResult> filterCorners(const std::vector<CornerPair>& corners,
                                             const RigidTransform& prediction,
                                             const Eigen::Vector2d& pivot_b,
                                             const BoxKalmanOptions& options) {
  CornerFilter filter(prediction, pivot_b, options);
  BoxKalmanResult result;
  for (const CornerPair& corner : corners) {
    result.used += filter.observe(corner, options.gate) ? 1 : 0;
  }
  if (result.used == 0) {
    return std::nullopt;
  }
  result.b_in_a = filter.transform();
  result.covariance = filter.covariance();
  return result;
}

}  // namespace sbox
