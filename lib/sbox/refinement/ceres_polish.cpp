// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/ceres_polish.h"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "sbox/alignment/robust_kernel.h"
#include "sbox/core/cholesky.h"

namespace sbox {
namespace {

using Vector = Eigen::Vector2d;

/// By a parameter block (x, y, heading), the pose of the pivot of b in map a: moves what is given
/// from the pivot.
PointMover moverOf(const double* pose) { return PointMover({pose[2], Vector(pose[0], pose[1])}); }

/// Derivative of the turned arm by the heading.
Vector turnedAcross(const PointMover& pose, const Vector& arm) {
  return pose.turn(Vector(-arm.y(), arm.x()));
}

/// W (R arm + t - in_a), where R and t are of the pose and W is `weight`.
class CornerCost final : public ceres::SizedCostFunction<2, 3> {
 public:
  CornerCost(Vector arm, Vector in_a, Eigen::Matrix2d weight)
      : arm_(std::move(arm)), in_a_(std::move(in_a)), weight_(std::move(weight)) {}
  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const PointMover pose = moverOf(parameters[0]);
    const Vector offset = weight_ * (pose(arm_) - in_a_);
    residuals[0] = offset.x();
    residuals[1] = offset.y();
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      const Vector by_heading = weight_ * turnedAcross(pose, arm_);
      for (int row = 0; row < 2; ++row) {
        double* derivatives = jacobians[0] + 3 * row;
        derivatives[0] = weight_(row, 0);
        derivatives[1] = weight_(row, 1);
        derivatives[2] = by_heading[row];
      }
    }
    return true;
  }

 private:
  Vector arm_, in_a_;
  Eigen::Matrix2d weight_;  ///< Square root of the relative information.
};

/// n . (R arm + t - p), where n is the normal of a line of a through p.
class WallCost final : public ceres::SizedCostFunction<1, 3> {
 public:
  WallCost(Vector arm, Vector on_line, Vector normal)
      : arm_(std::move(arm)), on_line_(std::move(on_line)), normal_(std::move(normal)) {}
  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const PointMover pose = moverOf(parameters[0]);
    residuals[0] = normal_.dot(pose(arm_) - on_line_);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      jacobians[0][0] = normal_.x();
      jacobians[0][1] = normal_.y();
      jacobians[0][2] = normal_.dot(turnedAcross(pose, arm_));
    }
    return true;
  }

 private:
  Vector arm_, on_line_, normal_;
};

/// R n . (R arm + t - p), where n is the normal of a line of b at `arm` from the pivot.
class LineCost final : public ceres::SizedCostFunction<1, 3> {
 public:
  LineCost(Vector arm, Vector normal, Vector point)
      : arm_(std::move(arm)), normal_(std::move(normal)), point_(std::move(point)) {}
  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const PointMover pose = moverOf(parameters[0]);
    const Vector normal = pose.turn(normal_), from_point = Vector(pose.x, pose.y) - point_;
    residuals[0] = normal.dot(pose.turn(arm_) + from_point);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      jacobians[0][0] = normal.x();
      jacobians[0][1] = normal.y();
      // The arm turns with the normal, so their product stays.
      jacobians[0][2] = turnedAcross(pose, normal_).dot(from_point);
    }
    return true;
  }

 private:
  Vector arm_, normal_, point_;
};

/// Geman and McClure's loss: r^2 for small residuals, never more than scale^2.
class GemanMcClure final : public ceres::LossFunction {
 public:
  explicit GemanMcClure(double scale) : scale_(scale) {}
  void Evaluate(double squared, double out[3]) const override {
    const double share = gemanMcClureShare(squared, scale_);
    out[0] = squared * share;
    out[1] = share * share;
    out[2] = -2 * share * share * share / (scale_ * scale_);
  }

 private:
  double scale_;
};

/// One round: its residuals, and the pose in Ceres's hands.
class Round {
 public:
  Round(const RigidTransform& b_in_a, const Eigen::Vector2d& pivot_b, double scale)
      : pivot_b_(pivot_b), kernel_(scale), problem_(ownKernel()) {
    const Eigen::Vector2d place = b_in_a * pivot_b;
    pose_ = {place.x(), place.y(), b_in_a.heading};
  }

  /// Pairs the walls of both maps under `b_in_a`; returns how many pairs there are.
  size_t addWalls(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
                  double reach, size_t most_points) {
    const PointMover to_a(b_in_a), to_b(b_in_a.inverse());
    const ByteAngle byte_turn = toByteAngle(b_in_a.heading);
    const auto near = [&](const MapFeatures& map, const Eigen::Vector2d& p,
                          ByteAngle direction) -> const WallPoint* {
      const std::ptrdiff_t cell = map.fields.cellAt(p.x(), p.y());
      if (cell < 0) {
        return nullptr;
      }
      const std::int32_t nearest =
          map.fields.nearest[sectorOf(direction)][static_cast<size_t>(cell)];
      if (nearest < 0) {
        return nullptr;
      }
      const WallPoint& point = map.wall_points[static_cast<size_t>(nearest)];
      return (point.position - p).norm() <= reach ? &point : nullptr;
    };
    size_t pairs = 0;
    for (size_t i = 0; i < std::min(most_points, b.wall_points.size()); ++i) {
      const WallPoint& point = b.wall_points[i];
      const auto direction = static_cast<ByteAngle>(b.wall_directions[i] + byte_turn);
      if (const WallPoint* line = near(a, to_a(point.position), direction)) {
        add(createWallCost(point, *line, pivot_b_), &kernel_);
        ++pairs;
      }
    }
    for (size_t i = 0; i < std::min(most_points, a.wall_points.size()); ++i) {
      const WallPoint& point = a.wall_points[i];
      const auto direction = static_cast<ByteAngle>(a.wall_directions[i] - byte_turn);
      if (const WallPoint* line = near(b, to_b(point.position), direction)) {
        add(createLineCost(*line, point, pivot_b_), &kernel_);
        ++pairs;
      }
    }
    return pairs;
  }

  /// `share`: the weight of each corner over that of a pair of walls.
  void addCorners(const std::vector<CornerPair>& corners, size_t count, double share,
                  double corner_noise) {
    corner_kernel_ =
        std::make_unique<ceres::ScaledLoss>(&kernel_, share, ceres::DO_NOT_TAKE_OWNERSHIP);
    for (size_t i = 0; i < count; ++i) {
      // Evenly over the list, which goes from box to box.
      const CornerPair& corner = corners[i * corners.size() / count];
      add(createCornerCost(corner, pivot_b_, corner_noise), corner_kernel_.get());
    }
  }

  [[nodiscard]] RigidTransform solve(int iterations) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = iterations;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    options.function_tolerance = 1e-6;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    RigidTransform b_in_a;
    b_in_a.heading = pose_[2];
    b_in_a.translation =
        Eigen::Vector2d(pose_[0], pose_[1]) - Eigen::Rotation2Dd(pose_[2]) * pivot_b_;
    return b_in_a;
  }

 private:
  static ceres::Problem::Options ownKernel() {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }
  void add(ceres::CostFunction* cost, ceres::LossFunction* loss) {
    problem_.AddResidualBlock(cost, loss, pose_.data());
  }

  Eigen::Vector2d pivot_b_;
  std::array<double, 3> pose_{};
  GemanMcClure kernel_;
  std::unique_ptr<ceres::ScaledLoss> corner_kernel_;
  ceres::Problem problem_;
};

}  // namespace

ceres::CostFunction* createCornerCost(const CornerPair& corner, const Eigen::Vector2d& pivot_b,
                                      double corner_noise) {
  // R = L L^T, so that |L^-1 e|^2 = e^T R^-1 e.
  const Eigen::Matrix2d root = choleskyFactor(corner.covariance);
  const Eigen::Matrix2d weight = corner_noise * root.inverse();
  return new CornerCost(corner.in_b - pivot_b, corner.in_a, weight);
}

ceres::CostFunction* createWallCost(const WallPoint& point_b, const WallPoint& line_a,
                                    const Eigen::Vector2d& pivot_b) {
  return new WallCost(point_b.position - pivot_b, line_a.position, line_a.normal);
}

ceres::CostFunction* createLineCost(const WallPoint& line_b, const WallPoint& point_a,
                                    const Eigen::Vector2d& pivot_b) {
  return new LineCost(line_b.position - pivot_b, line_b.normal, point_a.position);
}

std::optional<RigidTransform> polishByCeres(const MapFeatures& a, const MapFeatures& b,
                                            const std::vector<CornerPair>& corners,
                                            const RigidTransform& start,
                                            const Eigen::Vector2d& pivot_b,
                                            const PolishOptions& options) {
  RigidTransform b_in_a = start;
  for (int i = 0; i < options.rounds; ++i) {
    const double scale = scaleOfRound(i, options.rounds, options.first_scale, options.last_scale);
    Round round(b_in_a, pivot_b, scale);
    // Beyond three scales the loss is flat; nearer than a cell of the fields nothing is told apart.
    const double reach = 3 * scale + a.fields.resolution;
    const size_t walls = round.addWalls(a, b, b_in_a, reach, options.most_points);
    if (walls == 0) {
      return std::nullopt;
    }
    const size_t count = std::min(options.most_corners, corners.size());
    if (count > 0 && options.corner_weight > 0) {
      round.addCorners(
          corners, count,
          options.corner_weight * static_cast<double>(walls) / static_cast<double>(count),
          options.corner_noise);
    }
    b_in_a = round.solve(options.iterations);
  }
  return b_in_a;
}

}  // namespace sbox
