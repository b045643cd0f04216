// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox-paper/coincidence.h"

using namespace sbox;
using namespace sbox::paper;

namespace {

/// A room of 6 m x 4 m that both robots look round in; without noise and drift.
RobotPair twoInOneRoom(const Pose2D& start_a, const Pose2D& start_b) {
  RobotPair pair;
  pair.world.walls = {{{0, 0}, {6, 0}}, {{6, 0}, {6, 4}}, {{6, 4}, {0, 4}}, {{0, 4}, {0, 0}}};
  dataset::DriveOptions options;
  options.range_sigma = options.odometry_sigma = options.heading_sigma = 0;
  options.field_of_view = 2 * M_PI;
  const std::array<Pose2D, 2> starts{start_a, start_b};
  for (size_t i = 0; i < 2; ++i) {
    pair.runs[i] = drive(pair.world, {starts[i], {{3, 2}}}, options);
    pair.maps[i] = mapRun("room", pair.runs[i]);
  }
  return pair;
}

}  // namespace

TEST_CASE("under the true transform all walls coincide", "[coincidence]") {
  const Pose2D a(1, 1, 0.4), b(4.5, 3, -2);
  const Coincidence result = wallCoincidence(twoInOneRoom(a, b), inverse(a) + b);
  CHECK(result.edges == 4);
  CHECK(result.apart_edges == 0);
  CHECK(result.length == Approx(20).margin(1.5));  // Cells hide behind the corners.
  CHECK(result.share() < 0.02);
  CHECK(result.mean_gap < 0.05);
}

TEST_CASE("a shift along x parts the walls across it and no others", "[coincidence]") {
  const Pose2D a(1, 1, 0), b(4.5, 3, 0);
  const Pose2D shifted = inverse(a) + b + Pose2D(0.2, 0, 0);
  const Coincidence result = wallCoincidence(twoInOneRoom(a, b), shifted);
  CHECK(result.edges == 4);
  CHECK(result.apart_edges == 2);
  CHECK(result.share() == Approx(8.0 / 20).margin(0.03));
}
