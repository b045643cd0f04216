// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every peer finds the pose between two views of one drawn flat.
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "catch.h"
#include "sbox-bench/method_list.h"
#include "sbox-bench/methods/correlation.h"
#include "sbox-bench/methods/hough_matching.h"
#include "sbox-bench/methods/keypoints.h"
#include "sbox-bench/methods/map_merge.h"
#include "sbox-bench/methods/mrpt_aligner.h"

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

/// Those that do not care about the size of cells.
std::vector<Peer> resamplingPeers() {
  KeypointOptions orb, sift;
  sift.kind = KeypointKind::Sift;
  return {{correlationMethod(), 0.3, 0.03},
          {houghMethod(), 0.3, 0.03},
          {keypointMethod(orb), 0.75, 0.1},
          {keypointMethod(sift), 0.75, 0.1}};
}

std::vector<Peer> peers() {
  std::vector<Peer> result = resamplingPeers();
  result.push_back({mapMergeMethod(), 0.1, 0.01});
  if (const std::optional<Method> mrpt = mrptMethod()) {
    result.push_back({*mrpt, 0.1, 0.01});
  }
  return result;
}

PairResult answer(const Method& method, const Map& a, const Map& b) {
  return method.match(method.features(a), method.features(b));
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
      const PairResult result = answer(method, a, b);
      REQUIRE(result.has_pose);
      CHECK(result.verdict == Verdict::Accepted);
      const Pose2D error = inverse(pose_b_in_a) + result.pose_b_in_a;
      CHECK(std::hypot(error.x, error.y) < metres);
      CHECK(std::abs(wrapAngle(error.phi)) < radians);
    }
  }
}

TEST_CASE("peers that resample join maps of unlike cell size", "[bench][methods]") {
  const Pose2D pose_b_in_a(1, -2, 0.7);
  const Map a = view({}, 0.05, {-8, -9, 0});
  const Map b = view(pose_b_in_a, 0.025, {-16, -15, 0});
  for (const auto& [method, metres, radians] : resamplingPeers()) {
    INFO(method.name);
    const PairResult result = answer(method, a, b);
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
      const PairResult result = answer(method, *a, *b);
      CHECK_FALSE(result.has_pose);
      CHECK(result.verdict == Verdict::Rejected);
      CHECK_FALSE(result.reason.empty());
    }
  }
}

TEST_CASE("each peer gives the same answer again", "[bench][methods]") {
  const Map a = view({}, 0.05, {-8, -9, 0}), b = view({1, -2, 0.7}, 0.05, {-16, -15, 0});
  for (const Peer& peer : peers()) {
    INFO(peer.method.name);
    const PairResult first = answer(peer.method, a, b), second = answer(peer.method, a, b);
    CHECK(first.pose_b_in_a == second.pose_b_in_a);
    CHECK(first.confidence == second.confidence);
  }
}

TEST_CASE("the similarity of map_merge takes up unlike cell sizes", "[bench][methods]") {
  const Pose2D pose_b_in_a(1, -2, 0.7);
  const Map a = view({}, 0.05, {-8, -9, 0}), b = view(pose_b_in_a, 0.025, {-16, -15, 0.5});
  MapMergeOptions options;
  options.confidence = 0.4;  // Fewer keypoints agree than the package asks for.
  const PairResult result = answer(mapMergeMethod(options), a, b);
  REQUIRE(result.has_pose);
  const Pose2D error = inverse(pose_b_in_a) + result.pose_b_in_a;
  CHECK(std::hypot(error.x, error.y) < 0.1);
  CHECK(std::abs(wrapAngle(error.phi)) < 0.01);
}

TEST_CASE("map_merge refuses below its confidence", "[bench][methods]") {
  const Map flat = view({}, 0.05, {-8, -9, 0});
  MapMergeOptions options;
  options.confidence = 10;  // More than inliers / (8 + 0.3 matches) can be.
  CHECK(answer(mapMergeMethod(), flat, flat).verdict == Verdict::Accepted);
  const PairResult result = answer(mapMergeMethod(options), flat, flat);
  CHECK(result.verdict == Verdict::Rejected);
  CHECK_FALSE(result.has_pose);
}

TEST_CASE("map_merge refuses at its confidence", "[bench][methods]") {
  const Map a = view({}, 0.05, {-8, -9, 0}), b = view({1, -2, 0.5}, 0.025, {-16, -15, 0.5});
  MapMergeOptions options;
  options.confidence = answer(mapMergeMethod(), a, b).confidence;
  REQUIRE(options.confidence < 1);
  CHECK(answer(mapMergeMethod(options), a, b).verdict == Verdict::Rejected);
  options.confidence -= 1e-6;
  CHECK(answer(mapMergeMethod(options), a, b).verdict == Verdict::Accepted);
}

TEST_CASE("MRPT's aligner refuses maps of unlike cell size", "[bench][methods]") {
  const std::optional<Method> mrpt = mrptMethod();
  if (!mrpt) {
    WARN("skipped: this MRPT has no CGridMapAligner");
    return;
  }
  const PairResult result = answer(*mrpt, view({}, 0.05, {-8, -9, 0}), view({}, 0.1, {-8, -9, 0}));
  CHECK(result.verdict == Verdict::Rejected);
  CHECK_FALSE(result.has_pose);
  CHECK_FALSE(result.reason.empty());
}

TEST_CASE("a method is found by each name that is listed", "[bench][methods]") {
  const std::vector<std::string> names = methodNames();
  for (const std::string& name : names) {
    CHECK(methodByName(name).name == name);
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  }
  const auto listed = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  CHECK(listed("map_merge"));
  CHECK(listed("mrpt") == mrptMethod().has_value());
  CHECK_THROWS_AS(methodByName("nonsense"), std::invalid_argument);
}

TEST_CASE("the options of a variant are set, and no other text is taken", "[bench][methods]") {
  const Map a = view({2, 3, 0}, 0.05, {0, 0, 0}), b = view({5, 4, 0.5}, 0.05, {0, 0, 0});
  const auto answer = [&](const Method& method) {
    return method.match(method.features(a), method.features(b));
  };
  const std::string strict = "verification.accept_from=1,matching.votes.box_weight=0";
  CHECK(methodWith(strict).name == strict);
  CHECK(answer(methodWith("verification.accept_from=0.5")).verdict == Verdict::Accepted);
  CHECK(answer(methodWith(strict)).verdict != Verdict::Accepted);
  CHECK(answer(methodWith("merge.method=paper")).pose_b_in_a.phi ==
        answer(methodByName("paper")).pose_b_in_a.phi);
  for (const char* text : {"accept_from=1", "verification.accept_from", "verification.accept=1",
                           "verify.accept_from=1", "verification.accept_from=2", "x"}) {
    CHECK_THROWS_AS(methodWith(text), std::invalid_argument);
  }
}
