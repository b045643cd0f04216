// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/kalman_step.h"

#include <Eigen/LU>
#include <cmath>

#include "sbox/core/rigid_fit.h"

namespace sbox {
namespace {

Eigen::Vector2d vectorOf(const Point2D& p) { return {p.x, p.y}; }

Point2D meanOf(const std::array<Point2D, 4>& points) {
  return (points[0] + points[1] + points[2] + points[3]) * 0.25;
}

/// Length of the box along the direction of its side from corner 0 to 1: the mean of two sides.
double lengthAlong(const std::array<Point2D, 4>& z, size_t from) {
  const auto side = [&](size_t i, size_t j) {
    return std::hypot(z[j].x - z[i].x, z[j].y - z[i].y);
  };
  return 0.5 * (side(from, from + 1) + side((from + 2) % 4, (from + 3) % 4));
}

/// Eq. 12: half the mismatch of the sides, along the sides of box b.
Eigen::Matrix2d observationCovariance(const MatchedBoxes& boxes) {
  const double dw = 0.5 * (lengthAlong(boxes.corners_a, 0) - lengthAlong(boxes.corners_b, 0));
  const double dh = 0.5 * (lengthAlong(boxes.corners_a, 1) - lengthAlong(boxes.corners_b, 1));
  const Point2D side = boxes.corners_b[1] - boxes.corners_b[0];
  const double angle = std::atan2(side.y, side.x);
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix2d axes;
  axes << c, -s, s, c;
  return axes * Eigen::Vector2d(dw * dw, dh * dh).asDiagonal() * axes.transpose();
}

/// Eq. 13. Where neither prediction nor observation is uncertain they agree, and any weight will
/// do.
Eigen::Matrix2d predictionWeight(const Eigen::Matrix2d& r, const Eigen::Matrix2d& p) {
  const Eigen::Matrix2d sum = r + p;
  const double scale = sum.trace();
  if (sum.determinant() <= 1e-12 * scale * scale) {
    return Eigen::Matrix2d::Identity();
  }
  return r * sum.inverse();
}

}  // namespace

MatchedBoxes matchedBoxes(const SuppositionalBox& box_a, const SuppositionalBox& box_b, int shift) {
  MatchedBoxes boxes;
  boxes.corners_a = box_a.corners;
  for (size_t i = 0; i < 4; ++i) {
    boxes.corners_b[i] = box_b.corners[(i + static_cast<size_t>(shift)) % 4];
  }
  return boxes;
}

KalmanStep::KalmanStep(const MatchedBoxes& boxes, const Pose2D& pose_a_in_b)
    : prediction_(pose_a_in_b),
      centre_a_(meanOf(boxes.corners_a)),
      shift_(vectorOf(meanOf(boxes.corners_b) - pose_a_in_b.composePoint(centre_a_))),
      observation_covariance_(observationCovariance(boxes)) {
  for (size_t i = 0; i < 4; ++i) {
    std::vector<Point2D> from, to;
    for (size_t k = 0; k < 3; ++k) {
      from.push_back(boxes.corners_a[(i + k) % 4]);
      to.push_back(boxes.corners_b[(i + k) % 4]);
    }
    poses_[i] = fitRigid(from, to);
    transforms_.emplace_back(poses_[i]);
  }
}

KalmanEstimate KalmanStep::at(const Point2D& point_in_a) const {
  KalmanEstimate e;
  e.prediction = vectorOf(prediction_(point_in_a));
  std::array<Eigen::Vector2d, 4> spread;
  Eigen::Vector2d mean(0, 0);
  for (size_t i = 0; i < 4; ++i) {
    spread[i] = vectorOf(transforms_[i](point_in_a));
    mean += spread[i] / 4;
  }
  Eigen::Vector2d variance(0, 0);
  for (const Eigen::Vector2d& v : spread) {
    variance += (v - mean).cwiseAbs2() / 4;
  }
  e.prediction_covariance = variance.asDiagonal();
  e.observation = e.prediction + shift_;
  e.observation_covariance = observation_covariance_;
  e.gain = predictionWeight(e.observation_covariance, e.prediction_covariance);
  const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity() - e.gain;
  e.estimate = e.gain * e.prediction + rest * e.observation;
  e.covariance = e.gain * e.prediction_covariance * e.gain.transpose() +
                 rest * e.observation_covariance * rest.transpose();
  return e;
}

KalmanResult refineByKalman(const StateGrid& grid_a, const StateGrid& grid_b,
                            const MatchedBoxes& boxes, const Pose2D& pose_a_in_b) {
  const KalmanStep step(boxes, pose_a_in_b);
  const double cell = grid_b.resolution;
  const auto rounded = [cell](double v) { return (std::floor(v / cell) + 0.5) * cell; };
  std::vector<Point2D> from, to;
  for (int y = 0; y < grid_a.height; ++y) {
    for (int x = 0; x < grid_a.width; ++x) {
      if (grid_a.at(x, y) != CellState::Unknown) {
        const Point2D point((x + 0.5) * grid_a.resolution, (y + 0.5) * grid_a.resolution);
        const Eigen::Vector2d estimate = step.at(point).estimate;
        from.push_back(point);
        to.emplace_back(rounded(estimate.x()), rounded(estimate.y()));
      }
    }
  }
  KalmanResult result;
  result.pose_a_in_b = from.empty() ? pose_a_in_b : fitRigid(from, to);

  const double rounding = cell * cell / 12;
  const Eigen::Matrix2d centre_covariance =
      step.at(step.centreInA()).covariance + rounding * Eigen::Matrix2d::Identity();
  const Point2D diagonal = boxes.corners_a[2] - boxes.corners_a[0];
  double heading_variance = rounding / (diagonal.x * diagonal.x + diagonal.y * diagonal.y);
  for (const Pose2D& t : step.poses()) {
    const double deviation = wrapAngle(t.phi - pose_a_in_b.phi);
    heading_variance += deviation * deviation / 4;
  }
  // The translation is that of the box's centre less the turned centre: the heading's error enters
  // along the normal of the lever.
  const double c = std::cos(result.pose_a_in_b.phi), s = std::sin(result.pose_a_in_b.phi);
  const Point2D& centre = step.centreInA();
  const Eigen::Vector2d lever(s * centre.x + c * centre.y, -(c * centre.x - s * centre.y));
  result.covariance.topLeftCorner<2, 2>() =
      centre_covariance + heading_variance * lever * lever.transpose();
  result.covariance.topRightCorner<2, 1>() = heading_variance * lever;
  result.covariance.bottomLeftCorner<1, 2>() = heading_variance * lever.transpose();
  result.covariance(2, 2) = heading_variance;
  return result;
}

}  // namespace sbox
