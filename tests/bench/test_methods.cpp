// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every peer finds the pose between two views of one drawn flat.
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox-bench/methods/correlation.h"
#include "sbox-bench/methods/hough_matching.h"
#include "sbox-bench/methods/keypoints.h"

using namespace sbox;
using namespace sbox::bench;

namespace {

/// Flat of four rooms of unlike size, 14 m by 10 m; walls are 0.2 m thick.
float freeProbability(const Point2D& p) {
  const auto inside = [&](double x0, double x1, double y0, double y1) {
    return p.x > x0 && p.x < x1 && p.y > y0 && p.y < y1;
  };
  if (!inside(0, 14, 0, 10)) {
    return 0.5F;
  }
  const bool door = inside(4.4, 5.2, 1, 2) || inside(9, 10, 3.2, 4) || inside(1, 2, 5.9, 6.3);
  const bool wall = !inside(0.2, 13.8, 0.2, 9.8) || inside(4.7, 4.9, 0, 10) ||
                    inside(4.8, 14, 3.5, 3.7) || inside(0, 4.8, 6, 6.2) ||
                    inside(10, 10.2, 3.6, 6) || inside(12.5, 14, 8, 10) || inside(2, 2.8, 2, 3);
  return wall && !door ? 0.02F : 0.98F;
}

/// The flat as a robot sees it whose map frame lies at `map_in_flat`.
Map view(const Pose2D& map_in_flat, double resolution, const Pose2D& corner_in_map) {
  const int cells = static_cast<int>(30 / resolution);
  Map map = makeMap("flat", cells, cells, resolution, corner_in_map);
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      map.grid.setCell(x, y, freeProbability(map_in_flat.composePoint(map.cellCentre(x, y))));
    }
  }
  return map;
}

struct Peer {
  Method method;
  double metres;   ///< It is right to this distance,
  double radians;  ///< and this angle.
};

std::vector<Peer> peers() {
  KeypointOptions orb, sift;
  sift.kind = KeypointKind::Sift;
  return {{correlationMethod(), 0.3, 0.03},
          {houghMethod(), 0.3, 0.03},
          {keypointMethod(orb), 0.75, 0.1},
          {keypointMethod(sift), 0.75, 0.1}};
}

}  // namespace

TEST_CASE("each peer finds a moved and turned view", "[bench][methods]") {
  const Pose2D a_in_flat(3, 2, 0.1);
  const Map a = view(a_in_flat, 0.05, {-12, -14, 0.2});
  for (const Pose2D& pose_b_in_a :
       {Pose2D(0.5, 0.25, 0), Pose2D(2, -1, 1.4), Pose2D(-1, 3, -2.8)}) {
    const Map b = view(a_in_flat + pose_b_in_a, 0.05, {-15, -15, 0});
    for (const auto& [method, metres, radians] : peers()) {
      INFO(method.name << " at " << pose_b_in_a.phi);
      const PairResult result = method.match(method.features(a), method.features(b));
      REQUIRE(result.has_pose);
      CHECK(result.verdict == Verdict::Accepted);
      const Pose2D error = inverse(pose_b_in_a) + result.pose_b_in_a;
      CHECK(std::hypot(error.x, error.y) < metres);
      CHECK(std::abs(wrapAngle(error.phi)) < radians);
    }
  }
}

TEST_CASE("each peer joins maps of unlike cell size", "[bench][methods]") {
  const Pose2D pose_b_in_a(1, -2, 0.7);
  const Map a = view({}, 0.05, {-8, -9, 0});
  const Map b = view(pose_b_in_a, 0.025, {-16, -15, 0});
  for (const auto& [method, metres, radians] : peers()) {
    INFO(method.name);
    const PairResult result = method.match(method.features(a), method.features(b));
    const Pose2D error = inverse(pose_b_in_a) + result.pose_b_in_a;
    CHECK(std::hypot(error.x, error.y) < metres);
    CHECK(std::abs(wrapAngle(error.phi)) < radians);
  }
}

TEST_CASE("a peer refuses a map without cells", "[bench][methods]") {
  const Map flat = view({}, 0.1, {-8, -9, 0}), nothing = makeMap("nothing", 40, 30, 0.1);
  for (const Peer& peer : peers()) {
    const Method& method = peer.method;
    INFO(method.name);
    for (const auto& [a, b] :
         {std::pair(&flat, &nothing), std::pair(&nothing, &flat), std::pair(&nothing, &nothing)}) {
      const PairResult result = method.match(method.features(*a), method.features(*b));
      CHECK_FALSE(result.has_pose);
      CHECK(result.verdict == Verdict::Rejected);
      CHECK_FALSE(result.reason.empty());
    }
  }
}
