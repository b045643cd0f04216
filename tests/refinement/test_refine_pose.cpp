// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "catch.h"
#include "sbox/refinement/refine_pose.h"

using namespace sbox;

namespace {

/// A room of free cells with walls about it, in cells of 0.1 m, and a niche that breaks its
/// symmetry.
Map room(int width, int height, bool with_ends) {
  const int rim = 4;
  Map map = makeMap("room", width + 2 * rim, height + 2 * rim, 0.1);
  const auto inside = [&](int x, int y) {
    const bool in_room = x >= rim && y >= rim && x < rim + width && y < rim + height;
    const bool in_niche = with_ends && x >= rim && x < rim + 15 && y >= rim && y < rim + 12;
    return in_room && !in_niche;
  };
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (inside(x, y)) {
        map.grid.setCell(x, y, 0.95F);
        continue;
      }
      bool is_wall = false;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          is_wall = is_wall || inside(x + dx, y + dy);
        }
      }
      const bool is_end = x < rim || x >= rim + width;
      if (is_wall && (with_ends || !is_end)) {
        map.grid.setCell(x, y, 0.05F);
      }
    }
  }
  return map;
}

RefinedPose refined(const MapFeatures& map, const RigidTransform& start) {
  const DriftField drift = estimateDrift(map, map, start);
  return refinePose(map, map, start, drift, matchBoxes(map, map, start, drift));
}

}  // namespace

TEST_CASE("a room comes back onto itself, by the walls, by the corners and by both") {
  const MapFeatures map = extractFeatures(room(80, 60, true));
  const RefinedPose pose = refined(map, {0.01, {0.12, -0.08}});
  CHECK(pose.b_in_a.translation.norm() < 0.03);
  CHECK(std::abs(pose.b_in_a.heading) < 0.005);
  REQUIRE(pose.kalman.has_value());
  CHECK((*pose.kalman * pose.pivot_b - pose.pivot_b).norm() < 0.06);
  REQUIRE(pose.ceres.has_value());
  CHECK((*pose.ceres * pose.pivot_b - pose.pivot_b).norm() < 0.03);
}

TEST_CASE("the covariance is positive, and large along a slide that nothing fixes") {
  const RefinedPose fixed = refined(extractFeatures(room(80, 60, true)), {0, {0, 0}});
  const RefinedPose slide = refined(extractFeatures(room(80, 60, false)), {0, {0, 0}});
  for (const RefinedPose* pose : {&fixed, &slide}) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(pose->covariance);
    CHECK(solver.eigenvalues().minCoeff() > 0);
  }
  CHECK(slide.covariance(0, 0) > 10 * slide.covariance(1, 1));
  CHECK(slide.covariance(0, 0) > 10 * fixed.covariance(0, 0));
}

TEST_CASE("Kalman and Ceres may differ by so much, and by more in bent maps", "[refinement]") {
  const MapFeatures map = extractFeatures(room(80, 60, true));
  const RigidTransform start = {0.01, {0.12, -0.08}};
  const DriftField drift = estimateDrift(map, map, start);
  const std::vector<BoxMatch> boxes = matchBoxes(map, map, start, drift);
  RefineOptions options;
  const auto isDoubtful = [&] {
    return refinePose(map, map, start, drift, boxes, options).is_doubtful;
  };
  const double difference = refinePose(map, map, start, drift, boxes, options).disagreement();
  REQUIRE(difference > 1e-4);
  REQUIRE(drift.roughness() > 1e-4);
  CHECK_FALSE(isDoubtful());
  options.large_difference = 1.1 * difference;
  CHECK_FALSE(isDoubtful());
  options.large_difference = 0.9 * difference;
  CHECK(isDoubtful());
  options.drift_free = 0.95 * drift.roughness();
  CHECK(isDoubtful());
  options.drift_free = 0.5 * drift.roughness();
  CHECK_FALSE(isDoubtful());
  options.drift_free = 0;
  options.large_difference = 0;
  CHECK(isDoubtful());
}
