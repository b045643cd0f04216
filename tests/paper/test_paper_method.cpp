// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/paper/paper_method.h"

using namespace sbox;
using test::drawMap;
using test::officeWalls;

namespace {

/// The first robot saw all but the east end, the second all but the west end.
std::vector<test::Wall> part(bool west) {
  std::vector<test::Wall> walls;
  for (test::Wall wall : officeWalls()) {
    for (Point2D* p : {&wall.from, &wall.to}) {
      p->x = west ? std::min(p->x, 18.0) : std::max(p->x, 3.0);
    }
    if (wall.from.x != wall.to.x || wall.from.x != (west ? 18.0 : 3.0)) {
      walls.push_back(wall);
    }
  }
  return walls;
}

const Pose2D kFirstInWorld(2, 1, 0);

/// The paper leaves the target value of agreeing matches open. Eq. 5 divides by a sum over them, so
/// a low one lets a wrong transform with few of them win from the true one with many.
PaperOptions highTarget() {
  PaperOptions options;
  options.best_pair.min_agreeing = 20;
  return options;
}

PairResult matchOffice(const Pose2D& second_in_world, double resolution_a = 0.05,
                       double resolution_b = 0.05) {
  return matchPaper(extractPaperFeatures(drawMap(part(true), kFirstInWorld, resolution_a)),
                    extractPaperFeatures(drawMap(part(false), second_in_world, resolution_b)),
                    highTarget());
}

void checkPose(const PairResult& result, const Pose2D& expected) {
  REQUIRE(result.has_pose);
  CHECK(result.pose_b_in_a.x == Approx(expected.x).margin(0.2));
  CHECK(result.pose_b_in_a.y == Approx(expected.y).margin(0.2));
  CHECK(std::abs(wrapAngle(result.pose_b_in_a.phi - expected.phi)) < 0.02);
}

}  // namespace

TEST_CASE("two robots' maps of an office are joined", "[paper]") {
  for (const Pose2D& second_in_world :
       {Pose2D(2, 1, 0), Pose2D(15, -6, 0), Pose2D(2, 1, 2.1), Pose2D(15, -6, -0.9)}) {
    const PairResult result = matchOffice(second_in_world);
    INFO(result.reason);
    CHECK(result.verdict == Verdict::Accepted);
    checkPose(result, inverse(kFirstInWorld) + second_in_world);
    CHECK(result.kalman.has_value());
    CHECK(result.matched_boxes.size() > 5);
    CHECK(result.confidence > 0);
    CHECK(result.confidence < 1);
    CHECK(Eigen::SelfAdjointEigenSolver<PoseCovariance>(result.covariance).eigenvalues()[0] > 0);
  }
}

TEST_CASE("swapping the maps gives the inverse", "[paper]") {
  const Pose2D second_in_world(15, -6, -0.9);
  const auto a = extractPaperFeatures(drawMap(part(true), kFirstInWorld, 0.05));
  const auto b = extractPaperFeatures(drawMap(part(false), second_in_world, 0.05));
  checkPose(matchPaper(b, a, highTarget()), inverse(second_in_world) + kFirstInWorld);
}

TEST_CASE("a map fits itself", "[paper]") {
  const auto features = extractPaperFeatures(drawMap(part(true), {4, 4, 0.3}, 0.05));
  checkPose(matchPaper(features, features), {0, 0, 0});
}

TEST_CASE("features are given in the map frame", "[paper]") {
  const Pose2D map_in_world(5, -3, 0.5);
  const auto features = extractPaperFeatures(drawMap(officeWalls(), map_in_world, 0.05));
  const auto& set = features.feature_set;
  REQUIRE(set.boxes.size() == features.boxes.size());
  CHECK(set.lines.size() >= 12);
  // The corners of the building are among the vertical points.
  for (const Point2D& corner : {Point2D(0, 0), Point2D(24, 0), Point2D(24, 14), Point2D(0, 14)}) {
    double nearest = 1e9;
    for (const Point2D& p : set.vertical_points) {
      const Point2D off = map_in_world.composePoint(p) - corner;
      nearest = std::min(nearest, std::hypot(off.x, off.y));
    }
    CHECK(nearest < 0.2);
  }
}

TEST_CASE("maps of different cell sizes are matched on the finer one, and the reason says so",
          "[paper]") {
  const Pose2D second_in_world(15, -6, -0.9);
  for (const bool first_is_coarser : {true, false}) {
    const PairResult result = first_is_coarser ? matchOffice(second_in_world, 0.1, 0.05)
                                               : matchOffice(second_in_world, 0.05, 0.1);
    checkPose(result, inverse(kFirstInWorld) + second_in_world);
    CHECK(result.reason.find(first_is_coarser ? "first map was resampled from 0.1 m to 0.05 m"
                                              : "second map was resampled from 0.1 m to 0.05 m") !=
          std::string::npos);
    for (const auto& [a, b] : result.matched_boxes) {
      CHECK(a >= 0);
      CHECK(b >= 0);
    }
  }
}

TEST_CASE("a map without walls is refused with a reason", "[paper]") {
  Map blank = makeMap("blank", 50, 50, 0.05);
  const auto none = extractPaperFeatures(blank);
  CHECK(none.boxes.empty());
  const auto office = extractPaperFeatures(drawMap(officeWalls(), {}, 0.05));
  for (const PairResult& result : {matchPaper(none, office), matchPaper(office, none)}) {
    CHECK(result.verdict == Verdict::Rejected);
    CHECK_FALSE(result.has_pose);
    CHECK(result.reason.find("no box of one map fits") == 0);
  }
}
