// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <random>

#include "catch.h"
#include "sbox-bench/annotated_truth.h"
#include "sbox/core/rigid_fit.h"

using namespace sbox;
using namespace sbox::bench;

namespace {

constexpr double kResolution = 0.05;

/// A pair whose points in b are those in a under the pose, each off by a draw of `sigma` cells,
/// with the rigid fit that pairs.json has.
AnnotatedPair annotated(const Pose2D& corner_a_in_corner_b, double sigma, int count,
                        std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, 400);
  std::normal_distribution<double> off(0, sigma);
  AnnotatedPair pair;
  const Pose2D in_cells(corner_a_in_corner_b.x / kResolution, corner_a_in_corner_b.y / kResolution,
                        corner_a_in_corner_b.phi);
  for (int i = 0; i < count; ++i) {
    const Point2D in_a(place(random), place(random));
    const Point2D in_b = in_cells.composePoint(in_a);
    pair.points_a.push_back(in_a);
    pair.points_b.emplace_back(in_b.x + off(random), in_b.y + off(random));
  }
  const Pose2D fit = fitRigid(pair.points_a, pair.points_b);
  pair.theta_deg = fit.phi * 180 / M_PI;
  pair.offset = {fit.x, fit.y};
  return pair;
}

}  // namespace

TEST_CASE("points that fit exactly leave the truth without error", "[bench]") {
  std::mt19937 random(3);
  const Pose2D truth(4, -2, 0.7), corner_a(1, 2, 0), corner_b(-3, 5, 0);
  const AnnotatedTruth found =
      annotatedTruth(annotated(truth, 0, 6, random), kResolution, corner_a, corner_b);
  const Pose2D expected = corner_a + inverse(truth) + inverse(corner_b);
  CHECK(found.pose_b_in_a.x == Approx(expected.x));
  CHECK(found.pose_b_in_a.y == Approx(expected.y));
  CHECK(found.pose_b_in_a.phi == Approx(expected.phi));
  CHECK(found.covariance.norm() < 1e-12);
}

TEST_CASE("the covariance of the truth is that of fits to points drawn anew", "[bench]") {
  std::mt19937 random(5);
  const Pose2D truth(4, -2, 0.7), expected = inverse(truth);
  double sum = 0;
  constexpr int draws = 2000;
  for (int i = 0; i < draws; ++i) {
    const AnnotatedTruth found =
        annotatedTruth(annotated(truth, 8, 30, random), kResolution, Pose2D(), Pose2D());
    const Point2D placed = found.pose_b_in_a.composePoint(found.centre_in_b);
    const Point2D true_place = expected.composePoint(found.centre_in_b);
    const Eigen::Vector3d error(placed.x - true_place.x, placed.y - true_place.y,
                                wrapAngle(found.pose_b_in_a.phi - expected.phi));
    sum += error.dot(found.covariance.ldlt().solve(error));
  }
  // The spread of the points is itself estimated, of 57 degrees of freedom: 3 * 57 / 55.
  CHECK(sum / draws == Approx(3.11).margin(0.25));
}
