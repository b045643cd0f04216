// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <vector>

#include "catch.h"
#include "sbox/refinement/pose_covariance.h"

using namespace sbox;
using Eigen::Matrix3d;
using Eigen::Vector2d;

namespace {

/// A metre of wall with this normal at this place about the pivot.
struct Metre {
  Vector2d normal;
  Vector2d arm;
};

Matrix3d informationOf(const std::vector<Metre>& walls, const Vector2d& pivot = {0, 0}) {
  Matrix3d information = Matrix3d::Zero();
  for (const Metre& wall : walls) {
    const Vector2d arm = wall.arm - pivot;
    const Eigen::Vector3d jacobian(wall.normal.x(), wall.normal.y(),
                                   wall.normal.y() * arm.x() - wall.normal.x() * arm.y());
    information += jacobian * jacobian.transpose();
  }
  return information;
}

/// The walls of a room of 10 m x 10 m about `middle`, metre by metre.
std::vector<Metre> room(const Vector2d& middle, bool with_ends = true) {
  std::vector<Metre> walls;
  for (double s = -4.5; s < 5; ++s) {
    walls.push_back({{0, 1}, middle + Vector2d(s, -5)});
    walls.push_back({{0, -1}, middle + Vector2d(s, 5)});
    if (with_ends) {
      walls.push_back({{1, 0}, middle + Vector2d(-5, s)});
      walls.push_back({{-1, 0}, middle + Vector2d(5, s)});
    }
  }
  return walls;
}

double smallest(const Matrix3d& covariance) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvalues().minCoeff();
}

}  // namespace

TEST_CASE("without drift the covariance is that of walls that err together", "[refinement]") {
  const Matrix3d information = informationOf(room({0, 0}));
  CovarianceOptions options;
  options.wall_noise = 0.1;
  options.correlation_length = 4;
  const Matrix3d covariance = poseCovariance(information, 0, options);
  // 20 m of wall fix each axis: five stretches of 4 m, of 0.1 m each.
  CHECK(covariance(0, 0) == Approx(0.01 / 5).epsilon(0.001));
  CHECK(covariance(1, 1) == Approx(0.01 / 5).epsilon(0.001));
  CHECK(std::abs(covariance(0, 1)) < 1e-9);
}

TEST_CASE("more drift and less wall make the covariance larger, none makes it zero",
          "[refinement]") {
  const Matrix3d information = informationOf(room({0, 0}));
  const double clean = poseCovariance(information, 0).trace();
  const double bent = poseCovariance(information, 0.2).trace();
  const double scarce = poseCovariance(0.5 * information, 0.2).trace();
  CHECK(smallest(poseCovariance(information, 0)) > 0);
  CHECK(bent > 10 * clean);
  CHECK(scarce > 1.5 * bent);
  const Matrix3d nothing = poseCovariance(Matrix3d::Zero(), 0.1);
  CHECK(nothing(0, 0) >= 900);
  CHECK(nothing(2, 2) >= 1);
  CHECK(nothing.allFinite());
}

TEST_CASE("along a slide that no wall fixes nothing is known", "[refinement]") {
  const Matrix3d covariance = poseCovariance(informationOf(room({0, 0}, false)), 0);
  CHECK(covariance(0, 0) == Approx(900).epsilon(0.01));
  CHECK(covariance(1, 1) < 0.01);
}

TEST_CASE("the pivot about which it is taken changes nothing but the point of view",
          "[refinement]") {
  const std::vector<Metre> walls = room({12, -3});
  const Vector2d pivot(12, -3);
  const Matrix3d near = poseCovariance(informationOf(walls, pivot), 0.15);
  const Matrix3d far = poseCovariance(informationOf(walls), 0.15);
  // A turn by delta about the far pivot carries the near one along by delta * (3, 12).
  Matrix3d lever = Matrix3d::Identity();
  lever(0, 2) = -pivot.y();
  lever(1, 2) = pivot.x();
  CHECK((lever * far * lever.transpose() - near).norm() < 1e-6 * near.norm());
}
