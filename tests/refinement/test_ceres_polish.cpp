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
  CornerPair corner() {
    Matrix2d root;
    root << any(1), any(1), any(1), any(1);
    return {point(), point(), root * root.transpose() + 0.05 * Matrix2d::Identity()};
  }
  Pose pose() { return {any(10), any(10), any(3)}; }

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

double sumOfSquares(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) {
    sum += value * value;
  }
  return sum;
}

/// A scale at which Geman and McClure's loss is the square.
constexpr double kNoLoss = 1e8;

/// The transform that a pose of the pivot stands for.
RigidTransform transformOf(const Pose& pose, const Vector2d& pivot_b) {
  return {pose[2], Vector2d(pose[0], pose[1]) - Eigen::Rotation2Dd(pose[2]) * pivot_b};
}

}  // namespace

TEST_CASE("a corner's cost is the offset weighed by its covariance", "[refinement]") {
  Numbers numbers(1);
  for (int i = 0; i < 20; ++i) {
    const Vector2d pivot_b = numbers.point();
    PolishPairs pairs;
    pairs.corners = {numbers.corner()};
    pairs.corner_noise = 0.3;
    pairs.corner_weight = 2;
    const Pose pose = numbers.pose();
    const auto residuals = residualsAt(Cost(createPolishCost(pairs, pivot_b, kNoLoss)), pose);
    REQUIRE(residuals.size() == 2);
    const CornerPair& corner = pairs.corners[0];
    const Vector2d offset = transformOf(pose, pivot_b) * corner.in_b - corner.in_a;
    CHECK(sumOfSquares(residuals) ==
          Approx(2 * 0.09 * offset.dot(corner.covariance.inverse() * offset)));
  }
}

TEST_CASE("a wall's cost is its distance from the line it is laid on", "[refinement]") {
  Numbers numbers(2);
  for (int i = 0; i < 20; ++i) {
    const Vector2d pivot_b = numbers.point();
    PolishPairs pairs;
    const WallPair of_a = {numbers.wall(), numbers.wall()}, of_b = {numbers.wall(), numbers.wall()};
    pairs.on_lines_of_a = {of_a};
    pairs.on_lines_of_b = {of_b};
    const Pose pose = numbers.pose();
    const RigidTransform b_in_a = transformOf(pose, pivot_b);
    const auto residuals = residualsAt(Cost(createPolishCost(pairs, pivot_b, kNoLoss)), pose);
    REQUIRE(residuals.size() == 2);
    CHECK(residuals[0] == Approx(of_a.a.normal.dot(b_in_a * of_a.b.position - of_a.a.position)));
    // In b's own frame, where the line stands still.
    CHECK(std::abs(residuals[1]) == Approx(std::abs(of_b.b.normal.dot(
                                        b_in_a.inverse() * of_b.a.position - of_b.b.position))));
  }
}

TEST_CASE("costs are Geman and McClure's, and know their derivatives", "[refinement]") {
  Numbers numbers(3);
  for (int i = 0; i < 20; ++i) {
    const Vector2d pivot_b = numbers.point();
    PolishPairs walls;
    walls.on_lines_of_a = {{numbers.wall(), numbers.wall()}, {numbers.wall(), numbers.wall()}};
    walls.on_lines_of_b = {{numbers.wall(), numbers.wall()}};
    PolishPairs corner;
    corner.corners = {numbers.corner()};
    corner.corner_weight = 1;
    const Pose pose = numbers.pose();
    constexpr double scale = 5;
    const auto lossOf = [](double squared) { return squared * 25 / (25 + squared); };

    const Cost walls_cost(createPolishCost(walls, pivot_b, scale));
    checkDerivatives(walls_cost, pose);
    const auto plain = residualsAt(Cost(createPolishCost(walls, pivot_b, kNoLoss)), pose);
    const auto robust = residualsAt(walls_cost, pose);
    REQUIRE(robust.size() == 3);
    for (size_t k = 0; k < 3; ++k) {
      CHECK(robust[k] * robust[k] == Approx(lossOf(plain[k] * plain[k])));
    }
    const Cost corner_cost(createPolishCost(corner, pivot_b, scale));
    checkDerivatives(corner_cost, pose);
    const auto offset = residualsAt(Cost(createPolishCost(corner, pivot_b, kNoLoss)), pose);
    CHECK(sumOfSquares(residualsAt(corner_cost, pose)) == Approx(lossOf(sumOfSquares(offset))));
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
