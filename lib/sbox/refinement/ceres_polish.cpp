// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/refinement/ceres_polish.h"

#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "sbox/alignment/robust_kernel.h"
#include "sbox/alignment/wall_pairs.h"
#include "sbox/core/cholesky.h"

namespace sbox {
namespace {

using Vector = Eigen::Vector2d;

/// Derivative of the turned arm by the heading.
Vector turnedAcross(const PointMover& pose, const Vector& arm) {
  return pose.turn(Vector(-arm.y(), arm.x()));
}

/// Takes residuals and their derivatives one after the other, and makes Geman and McClure's loss
/// rho of them, of which Ceres is to see the half: it squares and halves what it is given, so it is
/// given r sqrt(rho) / |r|. One cost function for all, as Ceres's own losses take one for each.
class RobustRows {
 public:
  /// `jacobian` may be null: none is asked for then.
  RobustRows(double scale, double* residuals, double* jacobian)
      : scale_(scale), residuals_(residuals), jacobian_(jacobian) {}

  void add(double residual, const Eigen::RowVector3d& jacobian) {
    const double share = gemanMcClureShare(residual * residual, scale_);
    put(std::sqrt(share) * residual, std::sqrt(share) * share * jacobian);
  }

  /// Both of one loss, which counts so many times.
  void add(const Vector& residuals, const Eigen::Matrix<double, 2, 3>& jacobian, double weight) {
    const double share = gemanMcClureShare(residuals.squaredNorm(), scale_);
    const double root = std::sqrt(share * weight);
    const Eigen::Matrix<double, 2, 3> robust =
        root *
        (jacobian - share / (scale_ * scale_) * residuals * (residuals.transpose() * jacobian));
    for (int row = 0; row < 2; ++row) {
      put(root * residuals[row], robust.row(row));
    }
  }

 private:
  void put(double residual, const Eigen::RowVector3d& jacobian) {
    *residuals_++ = residual;
    if (jacobian_ != nullptr) {
      std::copy(jacobian.data(), jacobian.data() + 3, jacobian_);
      jacobian_ += 3;
    }
  }

  double scale_;
  double* residuals_;
  double* jacobian_;
};

/// Over one parameter block (x, y, heading): the pose of the pivot of b in map a.
class PolishCost final : public ceres::CostFunction {
 public:
  PolishCost(const PolishPairs& pairs, const Vector& pivot_b, double scale) : scale_(scale) {
    const double noise = pairs.corner_noise;
    for (const WallPair& pair : pairs.on_lines_of_a) {
      on_lines_of_a_.push_back({pair.b.position - pivot_b, pair.a.normal, pair.a.position});
    }
    for (const WallPair& pair : pairs.on_lines_of_b) {
      on_lines_of_b_.push_back({pair.b.position - pivot_b, pair.b.normal, pair.a.position});
    }
    for (const CornerPair& corner : pairs.corners) {
      // R = L L^T, so that |L^-1 e|^2 = e^T R^-1 e.
      const Eigen::Matrix2d root = choleskyFactor(corner.covariance);
      corners_.push_back({corner.in_b - pivot_b, corner.in_a, noise * root.inverse()});
    }
    corner_weight_ = pairs.corner_weight;
    mutable_parameter_block_sizes()->push_back(3);
    set_num_residuals(
        static_cast<int>(on_lines_of_a_.size() + on_lines_of_b_.size() + 2 * corners_.size()));
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const double* block = parameters[0];
    const PointMover pose({block[2], Vector(block[0], block[1])});
    RobustRows rows(scale_, residuals, jacobians != nullptr ? jacobians[0] : nullptr);
    for (const auto& [arm, normal, on_line] : on_lines_of_a_) {
      rows.add(normal.dot(pose(arm) - on_line),
               {normal.x(), normal.y(), normal.dot(turnedAcross(pose, arm))});
    }
    for (const auto& [arm, normal_b, point] : on_lines_of_b_) {
      const Vector normal = pose.turn(normal_b), from_point = Vector(pose.x, pose.y) - point;
      // The arm turns with the normal, so their product stays.
      rows.add(normal.dot(pose.turn(arm) + from_point),
               {normal.x(), normal.y(), turnedAcross(pose, normal_b).dot(from_point)});
    }
    for (const auto& [arm, in_a, weight] : corners_) {
      Eigen::Matrix<double, 2, 3> jacobian;
      jacobian << weight, weight * turnedAcross(pose, arm);
      rows.add(weight * (pose(arm) - in_a), jacobian, corner_weight_);
    }
    return true;
  }

 private:
  struct OnLine {
    Vector arm;     ///< From the pivot to what lies in b.
    Vector normal;  ///< Of the line, in the frame of its own map.
    Vector in_a;
  };
  struct Corner {
    Vector arm, in_a;
    Eigen::Matrix2d weight;  ///< Square root of the relative information.
  };

  double scale_;
  std::vector<OnLine> on_lines_of_a_, on_lines_of_b_;
  std::vector<Corner> corners_;
  double corner_weight_ = 0;
};

/// Wall points of either map that lie near a wall of the other under `b_in_a`, with this.
PolishPairs pairWalls(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
                      double reach, size_t most_points) {
  PolishPairs pairs;
  const auto isNear = [&](const Vector& place, const WallPoint& wall) {
    return (wall.position - place).norm() <= reach;
  };
  forEachWallPair(
      a, b, b_in_a, most_points,
      [&](const WallPoint& point_b, const Vector& place, const WallPoint& line_a) {
        if (isNear(place, line_a)) {
          pairs.on_lines_of_a.push_back({line_a, point_b});
        }
      },
      [&](const WallPoint& point_a, const Vector& place, const WallPoint& line_b) {
        if (isNear(place, line_b)) {
          pairs.on_lines_of_b.push_back({point_a, line_b});
        }
      });
  return pairs;
}

/// The transform nearest to `start` at which the cost is least.
RigidTransform leastCost(const PolishPairs& pairs, const RigidTransform& start,
                         const Vector& pivot_b, double scale, int iterations) {
  const Vector place = start * pivot_b;
  std::array<double, 3> pose = {place.x(), place.y(), start.heading};
  ceres::Problem problem;
  problem.AddResidualBlock(createPolishCost(pairs, pivot_b, scale), nullptr, pose.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = iterations;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.function_tolerance = 1e-6;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  const auto [x, y, heading] = pose;
  return {heading, Vector(x, y) - Eigen::Rotation2Dd(heading) * pivot_b};
}

}  // namespace

ceres::CostFunction* createPolishCost(const PolishPairs& pairs, const Eigen::Vector2d& pivot_b,
                                      double scale) {
  return new PolishCost(pairs, pivot_b, scale);
}

std::optional<RigidTransform> polishByCeres(const MapFeatures& a, const MapFeatures& b,
                                            const std::vector<CornerPair>& corners,
                                            const RigidTransform& start,
                                            const Eigen::Vector2d& pivot_b,
                                            const PolishOptions& options) {
  RigidTransform b_in_a = start;
  const size_t corner_count = std::min(options.most_corners, corners.size());
  for (int i = 0; i < options.rounds; ++i) {
    const double scale = scaleOfRound(i, options.rounds, options.first_scale, options.last_scale);
    // Beyond three scales the loss is flat; nearer than a cell of the fields nothing is told apart.
    const double reach = 3 * scale + a.fields.resolution;
    PolishPairs pairs = pairWalls(a, b, b_in_a, reach, options.most_points);
    const size_t walls = pairs.on_lines_of_a.size() + pairs.on_lines_of_b.size();
    if (walls == 0) {
      return std::nullopt;
    }
    if (options.corner_weight > 0) {
      for (size_t k = 0; k < corner_count; ++k) {
        // Evenly over the list, which goes from box to box.
        pairs.corners.push_back(corners[k * corners.size() / corner_count]);
      }
      pairs.corner_noise = options.corner_noise;
      pairs.corner_weight = options.corner_weight * static_cast<double>(walls) /
                            static_cast<double>(std::max<size_t>(corner_count, 1));
    }
    b_in_a = leastCost(pairs, b_in_a, pivot_b, scale, options.iterations);
  }
  return b_in_a;
}

}  // namespace sbox
