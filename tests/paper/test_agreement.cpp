// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <map>

#include "catch.h"
#include "paper/box_worlds.h"
#include "sbox/paper/agreement.h"

using namespace sbox;

namespace {

constexpr double kSideTolerance = 0.6;

/// The filter by a walk through all rough matches.
std::vector<std::pair<int, int>> agreeByBruteForce(const std::vector<SuppositionalBox>& boxes_a,
                                                   const std::vector<SuppositionalBox>& boxes_b,
                                                   const Pose2D& pose_a_in_b, const RoughMatch& own,
                                                   double corner_distance) {
  RoughMatchOptions options;
  options.side_tolerance = kSideTolerance;
  options.max_matches = 1000000;
  std::map<int, std::pair<double, int>> best_of_a, best_of_b;
  for (const RoughMatch& m : findRoughMatches(boxes_a, boxes_b, options)) {
    const double d = largestCornerDistance(boxes_a[static_cast<size_t>(m.a)],
                                           boxes_b[static_cast<size_t>(m.b)], pose_a_in_b);
    if (m.a != own.a && m.b != own.b && d < corner_distance &&
        (best_of_a.count(m.a) == 0 || d < best_of_a[m.a].first)) {
      best_of_a[m.a] = {d, m.b};
    }
  }
  for (const auto& [a, partner] : best_of_a) {
    const auto [d, b] = partner;
    if (best_of_b.count(b) == 0 || d < best_of_b[b].first) {
      best_of_b[b] = {d, a};
    }
  }
  std::vector<std::pair<int, int>> matches;
  for (const auto& [b, partner] : best_of_b) {
    matches.emplace_back(partner.second, b);
  }
  std::sort(matches.begin(), matches.end());
  return matches;
}

}  // namespace

TEST_CASE("the largest corner distance is that of counterparts", "[paper]") {
  const SuppositionalBox box = describeBox({{{0, 0}, {5, 0}, {5, 2}, {0, 2}}});
  const SuppositionalBox longer = describeBox({{{0, 0}, {5.3, 0}, {5.3, 2.4}, {0, 2.4}}});
  CHECK(largestCornerDistance(box, longer, Pose2D()) == Approx(0.5));
  // Turned, another corner of the same box is the lower left one.
  const Pose2D quarter(1, 2, M_PI / 2);
  const SuppositionalBox turned = test::moved({box}, quarter, 0, 1)[0];
  CHECK(largestCornerDistance(box, turned, quarter) == Approx(0).margin(1e-9));
}

TEST_CASE("the index finds what a walk through all rough matches finds", "[paper]") {
  const Pose2D pose(4, -9, 0.8);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto boxes_a = test::randomBoxes(80, seed);
    const auto boxes_b = test::moved(boxes_a, pose, 0.3, seed + 100);
    for (const double corner_distance : {0.2, 0.4, 3.0}) {
      AgreementOptions options;
      options.corner_distance = corner_distance;
      const AgreementIndex index(boxes_a, boxes_b, kSideTolerance, options);
      for (const Pose2D& tried : {pose, Pose2D(4.2, -9.1, 0.81), Pose2D(0, 0, 0)}) {
        const RoughMatch own{3, 3};
        const Agreement agreement = index.find(tried, own);
        std::vector<std::pair<int, int>> found;
        double sum = 0;
        for (const RoughMatch& m : agreement.matches) {
          found.emplace_back(m.a, m.b);
          sum += largestCornerDistance(boxes_a[static_cast<size_t>(m.a)],
                                       boxes_b[static_cast<size_t>(m.b)], tried);
        }
        CHECK(found == agreeByBruteForce(boxes_a, boxes_b, tried, own, corner_distance));
        CHECK(agreement.distance_sum == Approx(sum).margin(1e-9));
      }
    }
  }
}

TEST_CASE("under the true transform all other boxes agree", "[paper]") {
  const Pose2D pose(4, -9, 0.8);
  const auto boxes_a = test::randomBoxes(40, 1);
  const auto boxes_b = test::moved(boxes_a, pose, 0, 2);
  const Agreement agreement = AgreementIndex(boxes_a, boxes_b, 0.1).find(pose, {0, 0});
  CHECK(agreement.matches.size() == 39);
  CHECK(agreement.distance_sum == Approx(0).margin(1e-9));
}

TEST_CASE("nothing agrees without boxes or far away", "[paper]") {
  const auto boxes = test::randomBoxes(5, 1);
  CHECK(AgreementIndex(boxes, {}, 0.5).find({}, {0, 0}).matches.empty());
  CHECK(AgreementIndex({}, boxes, 0.5).find({}, {0, 0}).matches.empty());
  CHECK(AgreementIndex(boxes, boxes, 0.5).find({1e12, -1e12, 0}, {0, 0}).matches.empty());
}
