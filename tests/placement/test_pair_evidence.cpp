// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/core/pose_errors.h"
#include "sbox/placement/pair_evidence.h"

using namespace sbox;

namespace {

PairEvidence pairWith(double probability) {
  PairEvidence pair;
  pair.candidates = {{Pose2D(), PoseCovariance::Identity(), probability}};
  pair.none = 1 - probability;
  return pair;
}

std::vector<PairEvidence> pairsWith(int related, int unrelated) {
  std::vector<PairEvidence> pairs(static_cast<size_t>(related), pairWith(0.999));
  pairs.insert(pairs.end(), static_cast<size_t>(unrelated), pairWith(0.001));
  return pairs;
}

}  // namespace

TEST_CASE("among many pairs of which few belong together, each is less probable",
          "[pair_evidence]") {
  std::vector<PairEvidence> pairs = pairsWith(10, 989);
  pairs.push_back(pairWith(0.9));
  weighByBaseRate(pairs);
  // One in about a hundred: odds of 9 become about 9 / 80.
  CHECK(pairs.back().candidates[0].probability == Approx(0.1).margin(0.03));
  CHECK(pairs.back().candidates[0].probability + pairs.back().none == Approx(1));
  CHECK(pairs[0].candidates[0].probability > 0.9);
}

TEST_CASE("where most pairs belong together, nothing becomes more probable", "[pair_evidence]") {
  std::vector<PairEvidence> pairs = pairsWith(90, 9);
  pairs.push_back(pairWith(0.6));
  weighByBaseRate(pairs);
  CHECK(pairs.back().candidates[0].probability == Approx(0.6));
}

TEST_CASE("a single pair keeps about its own probability", "[pair_evidence]") {
  for (const double probability : {0.7, 0.9, 0.99}) {
    std::vector<PairEvidence> pairs{pairWith(probability)};
    weighByBaseRate(pairs);
    CHECK(pairs[0].candidates[0].probability == Approx(probability));
  }
  std::vector<PairEvidence> none{pairWith(0.5)};
  none[0].candidates.clear();
  none[0].none = 1;
  weighByBaseRate(none);
  CHECK(none[0].none == Approx(1));
}

TEST_CASE("a covariance is believed however far the frame's zero is away", "[pair_evidence]") {
  // A centimetre and half a milliradian about the middle of map b.
  const PoseCovariance about_middle = Eigen::Vector3d(1e-4, 1e-4, 2.5e-7).asDiagonal();
  for (const double far : {0.0, 1e4, 5e5, 4e6}) {
    const Eigen::Matrix3d to_zero = leverTo({far, -0.7 * far});
    MapPair pair{0, 1, {}};
    pair.result.has_pose = true;
    pair.result.covariance = to_zero * about_middle * to_zero.transpose();
    INFO(far << " m");
    CHECK(evidenceOf(pair, {}, {}).candidates.at(0).covariance == pair.result.covariance);
  }
  MapPair broken{0, 1, {}};
  broken.result.has_pose = true;
  broken.result.covariance = Eigen::Vector3d(1, 1, -1e-6).asDiagonal();
  CHECK(evidenceOf(broken, {}, {}).candidates.at(0).covariance(2, 2) > 0);
}
