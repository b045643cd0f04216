// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/alignment/plausibility.h"

using namespace sbox;

TEST_CASE("maps that hardly meet are implausible", "[alignment]") {
  CHECK(plausibility({}) == kImplausible);
  Evidence evidence;
  evidence.known = 1;
  evidence.agree = 1;
  CHECK(plausibility(evidence) == kImplausible);
}

TEST_CASE("more wall that agrees, and more shared space, is more plausible", "[alignment]") {
  Evidence evidence;
  evidence.known = 60;
  evidence.free_free = 100;
  double last = kImplausible;
  for (const double agree : {0, 10, 30, 50, 60}) {
    evidence.agree = agree;
    const double found = plausibility(evidence);
    CHECK(std::isfinite(found));
    CHECK(found > last);
    last = found;
  }
  evidence.free_free = 150;
  CHECK(plausibility(evidence) > last);
}

TEST_CASE("of many transforms of a random office the true one is the most plausible",
          "[alignment]") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const MapFeatures office = extractFeatures(test::exploreMap(test::randomFloor(seed), {}, 0.1));
    const Eigen::Vector2d middle(office.width / 2, office.height / 2);
    const double truth = plausibility(gatherEvidence(office, office, {}, 300));
    double best_other = kImplausible;
    for (int turn = 0; turn < 8; ++turn) {
      const double heading = turn * M_PI / 4;
      for (int x = -8; x <= 8; ++x) {
        for (int y = -8; y <= 8; ++y) {
          if (turn != 0 || std::abs(x) > 1 || std::abs(y) > 1) {
            const RigidTransform other{
                heading, middle - Eigen::Rotation2Dd(heading) * middle + Eigen::Vector2d(x, y)};
            best_other =
                std::max(best_other, plausibility(gatherEvidence(office, office, other, 300)));
          }
        }
      }
    }
    INFO("seed " << seed);
    CHECK(truth > best_other + 1);
  }
}
