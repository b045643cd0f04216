// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ceres/cost_function.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "catch.h"
#include "drawing.h"
#include "sbox/refinement/ceres_polish.h"

using namespace sbox;
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

using Pose = std::array<double, 3>;
using Cost = std::unique_ptr<ceres::CostFunction>;

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double any(double reach) {
    return std::uniform_real_distribution<double>(-reach, reach)(random_);
  }
  Vector2d point() { return {any(10), any(10)}; }
  WallPoint wall() {
    const double facing = any(M_PI);
    return {point(), {std::cos(facing), std::sin(facing)}};
  }

 private:
  std::mt19937 random_;
};

std::vector<double> residualsAt(const Cost& cost, const Pose& pose,
                                std::vector<double>* jacobian = nullptr) {
  std::vector<double> residuals(static_cast<size_t>(cost->num_residuals()));
  const double* parameters[] = {pose.data()};
  double* jacobians[] = {nullptr};
  if (jacobian != nullptr) {
    jacobian->resize(3 * residuals.size());
    jacobians[0] = jacobian->data();
  }
  REQUIRE(cost->Evaluate(parameters, residuals.data(), jacobian == nullptr ? nullptr : jacobians));
  return residuals;
}

/// Central differences against what the cost says of itself.
void checkDerivatives(const Cost& cost, const Pose& pose) {
  std::vector<double> jacobian;
  const size_t count = residualsAt(cost, pose, &jacobian).size();
  constexpr double step = 1e-5;
  for (size_t k = 0; k < 3; ++k) {
    Pose more = pose, less = pose;
    more[k] += step;
    less[k] -= step;
    const auto high = residualsAt(cost, more), low = residualsAt(cost, less);
    for (size_t i = 0; i < count; ++i) {
      CHECK(jacobian[3 * i + k] == Approx((high[i] - low[i]) / (2 * step)).margin(1e-6));
    }
  }
}

/// The transform that a pose of the pivot stands for.
RigidTransform transformOf(const Pose& pose, const Vector2d& pivot_b) {
  return {pose[2], Vector2d(pose[0], pose[1]) - Eigen::Rotation2Dd(pose[2]) * pivot_b};
}

}  // namespace

TEST_CASE("a corner's cost is the offset weighed by its covariance", "[refinement]") {
  Numbers numbers(1);
  for (int i = 0; i < 20; ++i) {
    Matrix2d root;
    root << numbers.any(1), numbers.any(1), numbers.any(1), numbers.any(1);
    const Matrix2d covariance = root * root.transpose() + 0.05 * Matrix2d::Identity();
    const CornerPair corner{numbers.point(), numbers.point(), covariance};
    const Vector2d pivot_b = numbers.point();
    const Cost cost(createCornerCost(corner, pivot_b, 0.3));
    const Pose pose{numbers.any(10), numbers.any(10), numbers.any(3)};
    const auto residuals = residualsAt(cost, pose);
    REQUIRE(residuals.size() == 2);
    const Vector2d offset = transformOf(pose, pivot_b) * corner.in_b - corner.in_a;
    CHECK(residuals[0] * residuals[0] + residuals[1] * residuals[1] ==
          Approx(0.09 * offset.dot(covariance.inverse() * offset)));
    checkDerivatives(cost, pose);
  }
}

TEST_CASE("a wall's cost is its distance from the line it is laid on", "[refinement]") {
  Numbers numbers(2);
  for (int i = 0; i < 20; ++i) {
    const WallPoint point_b = numbers.wall(), line_a = numbers.wall();
    const Vector2d pivot_b = numbers.point();
    const Pose pose{numbers.any(10), numbers.any(10), numbers.any(3)};
    const RigidTransform b_in_a = transformOf(pose, pivot_b);
    const Cost cost(createWallCost(point_b, line_a, pivot_b));
    CHECK(residualsAt(cost, pose)[0] ==
          Approx(line_a.normal.dot(b_in_a * point_b.position - line_a.position)));
    checkDerivatives(cost, pose);
  }
}

TEST_CASE("a line's cost is how far a wall of the other map is from it", "[refinement]") {
  Numbers numbers(3);
  for (int i = 0; i < 20; ++i) {
    const WallPoint line_b = numbers.wall(), point_a = numbers.wall();
    const Vector2d pivot_b = numbers.point();
    const Pose pose{numbers.any(10), numbers.any(10), numbers.any(3)};
    const RigidTransform b_in_a = transformOf(pose, pivot_b);
    const Cost cost(createLineCost(line_b, point_a, pivot_b));
    // In b's own frame, where the line stands still.
    CHECK(
        std::abs(residualsAt(cost, pose)[0]) ==
        Approx(std::abs(line_b.normal.dot(b_in_a.inverse() * point_a.position - line_b.position))));
    checkDerivatives(cost, pose);
  }
}

TEST_CASE("least squares bring a map back onto another of the same floor", "[refinement]") {
  Numbers numbers(4);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const test::Floor floor = test::randomFloor(seed);
    const Pose2D b_in_world(3, 1, 0.8);
    const MapFeatures a = extractFeatures(test::exploreMap(floor, {}, 0.1));
    const MapFeatures b = extractFeatures(test::exploreMap(floor, b_in_world, 0.1));
    const Pose2D truth = inverse(a.grid_in_map) + b_in_world + b.grid_in_map;
    const RigidTransform b_in_a{truth.phi, {truth.x, truth.y}};
    const Vector2d pivot(b.width / 2, b.height / 2);
    const Pose off{(b_in_a * pivot).x() + numbers.any(0.3), (b_in_a * pivot).y() + numbers.any(0.3),
                   truth.phi + numbers.any(0.02)};
    const auto polished = polishByCeres(a, b, {}, transformOf(off, pivot), pivot);
    INFO("seed " << seed);
    REQUIRE(polished.has_value());
    CHECK((*polished * pivot - b_in_a * pivot).norm() < 0.05);
    CHECK(std::abs(polished->heading - truth.phi) < 0.005);
  }
}

TEST_CASE("corners count beside the walls, and walls must be there", "[refinement]") {
  const MapFeatures map = extractFeatures(test::exploreMap(test::officeFloor(), {}, 0.1));
  const Vector2d pivot(map.width / 2, map.height / 2);
  // Corners which say that the maps are 0.2 m off against walls which say that they are not.
  std::vector<CornerPair> corners;
  for (const Vector2d& p : {Vector2d(2, 2), Vector2d(20, 3), Vector2d(12, 12)}) {
    corners.push_back({p + Vector2d(0.2, 0), p, 0.0625 * Matrix2d::Identity()});
  }
  PolishOptions options;
  double last = -1;
  for (const double weight : {0.0, 0.5, 5.0, 500.0}) {
    options.corner_weight = weight;
    const auto polished = polishByCeres(map, map, corners, {}, pivot, options);
    REQUIRE(polished.has_value());
    const double moved = (*polished * pivot - pivot).x();
    CHECK(moved > last);
    CHECK(moved < 0.21);
    last = moved;
  }
  CHECK(last > 0.15);
  CHECK_FALSE(polishByCeres(map, map, corners, {0, {1000, 0}}, pivot).has_value());
}
