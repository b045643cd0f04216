// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox-dataset/drive.h"
#include "sbox-dataset/truth.h"

using namespace sbox;
using namespace sbox::dataset;

namespace {

/// A room of 6 m x 4 m with a corner cut off.
World room() {
  World world;
  world.walls = {
      {{0, 0}, {6, 0}}, {{6, 0}, {6, 3}}, {{6, 3}, {5, 4}}, {{5, 4}, {0, 4}}, {{0, 4}, {0, 0}}};
  return world;
}

DriveOptions withoutDrift() {
  DriveOptions options;
  options.odometry_sigma = options.heading_sigma = 0;
  return options;
}

}  // namespace

TEST_CASE("without drift the truth is where the robots started", "[truth]") {
  const Pose2D a_in_world(1, 1, 0.4), b_in_world(5, 2, -2.2);
  const Run a = drive(room(), {a_in_world, {{4, 1}}}, withoutDrift());
  const Run b = drive(room(), {b_in_world, {{1, 2}}}, withoutDrift());
  const auto truth = findTruth(a, b, mapRun("a", a), mapRun("b", b));
  REQUIRE(truth);
  const Pose2D expected = inverse(a_in_world) + b_in_world;
  CHECK(truth->pose_b_in_a.x == Approx(expected.x).margin(1e-6));
  CHECK(truth->pose_b_in_a.y == Approx(expected.y).margin(1e-6));
  CHECK(wrapAngle(truth->pose_b_in_a.phi - expected.phi) == Approx(0).margin(1e-6));
  CHECK(truth->rms < 1e-6);
  CHECK(truth->overlap > 0.9);
  CHECK(truth->places.size() > 10);
}

TEST_CASE("drift shows in what the best fit leaves", "[truth]") {
  DriveOptions drifting = withoutDrift();
  drifting.heading_sigma = 0.02;
  const Run a = drive(room(), {{1, 1, 0}, {{4, 1}, {4, 3}, {1, 3}}}, withoutDrift());
  const Run b = drive(room(), {{1, 1, 0}, {{4, 1}, {4, 3}, {1, 3}}}, drifting);
  const auto truth = findTruth(a, b, mapRun("a", a), mapRun("b", b));
  REQUIRE(truth);
  CHECK(truth->rms > 0.02);
}

TEST_CASE("robots in different rooms saw nothing in common", "[truth]") {
  World far;
  far.walls = {{{100, 0}, {101, 0}}, {{101, 0}, {101, 1}}};
  const Run a = drive(room(), {{1, 1, 0}, {}}), b = drive(far, {{100.5, 0.5, 0}, {}});
  CHECK_FALSE(findTruth(a, b, mapRun("a", a), mapRun("b", b)));
}
