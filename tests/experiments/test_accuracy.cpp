// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How well the default method does on simulated robots whose truth is known. Maps are made at the
// poses of a good odometry, which drifts as SLAM does and takes a tenth of the time.
//
// Tolerances are one and a half to three times the largest value over the seeds 1, 11 and 21,
// beside the checks, so that they fail when the method gets worse and not when a library rounds
// differently.
#include <string>
#include <vector>

#include "catch.h"
#include "sbox-bench/run_method.h"
#include "sbox-paper/adjusted_pair.h"
#include "sbox-paper/answers.h"
#include "sbox-paper/coincidence.h"
#include "sbox-paper/experiments/rooms.h"
#include "sbox-paper/robot_pair.h"

using namespace sbox;
using namespace sbox::paper;

namespace {

const std::string kDatasets = SBOX_DATASETS;

RobotPair simulated(const std::string& world, std::uint32_t seed) {
  return simulateWorld(kDatasets + "/worlds", world, Slam::None, seed);
}

PairResult solved(const RobotPair& robots) {
  return solve(defaultMethod(), robots.maps[0], robots.maps[1]);
}

}  // namespace

TEST_CASE("rooms are placed and their walls coincide", "[accuracy]") {
  for (const std::uint32_t seed : {1U, 11U, 21U}) {
    const RobotPair robots = simulated("rooms", seed);
    const PairResult answer = solved(robots);
    INFO("seed " << seed << ": " << answer.reason);
    REQUIRE(answer.verdict == Verdict::Accepted);
    REQUIRE(robots.truth);
    const PairError error = errorOf(answer.pose_b_in_a, *robots.truth);
    CHECK(error.excess < 0.06);       // Metres; 0.020 to 0.031.
    CHECK(error.rotation_deg < 0.4);  // 0.02 to 0.18; the best rigid fit has an error of its own.
    CHECK(wallCoincidence(robots, answer.pose_b_in_a).share() < 0.14);  // 0.056 to 0.093.
  }
}

TEST_CASE("walls coincide better when all scans are adjusted together", "[accuracy]") {
  for (const std::uint32_t seed : {1U, 11U, 21U}) {
    const RobotPair robots = simulated("rooms", seed);
    const PairResult answer = solved(robots);
    INFO("seed " << seed);
    REQUIRE(answer.has_pose);
    const RobotPair adjusted = adjustedPair(robots, answer.pose_b_in_a);
    const Coincidence before = wallCoincidence(robots, answer.pose_b_in_a);
    const Coincidence after = wallCoincidence(adjusted, Pose2D());
    CHECK(after.edges > 0.8 * before.edges);  // Nothing was moved out of sight.
    CHECK(after.share() < 0.015);             // 0.0055 to 0.0069.
  }
}

TEST_CASE("walls of the merged map have their length at any angle", "[accuracy]") {
  const RobotPair robots = simulated("rooms", 1);
  for (const double angle : {0.0, 45.0, 90.0, 163.0, 287.0}) {
    const TurnedLengths lengths = measureTurned(robots, angle);
    INFO(angle << " degrees");
    REQUIRE(lengths.verdict == Verdict::Accepted);
    const auto error = meanError(lengths.walls, &WallLengths::merged);
    REQUIRE(error);
    CHECK(*error < 0.01);  // 0.0025 to 0.0060.
  }
}

TEST_CASE("a long corridor of like rooms and walls at any angle are placed", "[accuracy]") {
  for (const std::string world : {"corridor", "angled"}) {
    for (const std::uint32_t seed : {1U, 11U}) {
      const RobotPair robots = simulated(world, seed);
      const PairResult answer = solved(robots);
      INFO(world << ", seed " << seed << ": " << answer.reason);
      REQUIRE(answer.verdict == Verdict::Accepted);
      CHECK(errorOf(answer.pose_b_in_a, *robots.truth).excess < 0.08);  // 0.014 to 0.036 m.
    }
  }
}

TEST_CASE("a corridor that looks the same in several places is called ambiguous", "[accuracy]") {
  for (const std::uint32_t seed : {1U, 11U, 21U}) {
    const PairResult answer = solved(simulated("symmetric", seed));
    INFO("seed " << seed << ": " << answer.reason);
    CHECK(answer.verdict == Verdict::Ambiguous);
    CHECK_FALSE(answer.alternatives.empty());
  }
}

TEST_CASE("random offices are merged, and maps of different offices are not", "[accuracy]") {
  std::vector<RobotPair> offices;
  for (std::uint32_t office = 1; office <= 6; ++office) {
    offices.push_back(simulateOffice(office, 0, 1, Slam::None));
  }
  for (size_t i = 0; i < offices.size(); ++i) {
    for (size_t k = 0; k < offices.size(); ++k) {
      const PairResult answer = solve(defaultMethod(), offices[i].maps[0], offices[k].maps[1]);
      INFO(offices[i].name << " with " << offices[k].name << ": " << answer.reason);
      if (i != k) {
        CHECK(answer.verdict != Verdict::Accepted);
      } else {
        REQUIRE(answer.verdict == Verdict::Accepted);
        CHECK(errorOf(answer.pose_b_in_a, *offices[i].truth).excess < 0.08);  // 0.014 to 0.026 m.
      }
    }
  }
}

TEST_CASE("the shipped maps are merged where they share enough", "[accuracy]") {
  for (const std::string name : {"office", "sena"}) {
    const bench::LoadedFolder loaded =
        bench::loadFolder(bench::readPairFolder(kDatasets + "/" + name));
    for (const bench::Answer& answer : bench::runMethod(defaultMethod(), loaded)) {
      INFO(name << ": " << answer.result.reason);
      CHECK(answer.outcome == bench::Outcome::Right);
    }
  }
}
