// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "io/contains.h"
#include "sbox/slam/bare_observations.h"
#include "sbox/slam/paired_entries.h"
#include "sbox/slam/run_slam.h"
#include "slam/driven_logs.h"

using namespace sbox;
using namespace sbox::test;

namespace {

/// The largest distance, in metres, of a key frame from the path, in the frame of the path's start.
double offPath(const KeyFrames& key_frames, const std::vector<Pose2D>& path) {
  double largest = 0;
  for (const KeyFrame& key_frame : key_frames) {
    const Pose2D pose = poseOf(key_frame);
    double nearest = 1e9;
    for (size_t i = 0; i < path.size(); ++i) {
      const Pose2D on_path = inverse(path[0]) + path[i];
      nearest = std::min(nearest, std::hypot(pose.x - on_path.x, pose.y - on_path.y) +
                                      std::abs(wrapAngle(pose.phi - on_path.phi)));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// Where the scans of bareLog were taken.
std::vector<Pose2D> halfWay() {
  const std::vector<Pose2D> path = drivenPath();
  std::vector<Pose2D> between;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const Pose2D next = inverse(path[i]) + path[i + 1];
    between.push_back(path[i] + Pose2D(next.x / 2, next.y / 2, next.phi / 2));
  }
  return between;
}

std::string errorOf(const ScanLog& log, const SlamOptions& options) {
  try {
    static_cast<void>(runSlam(log, options));
  } catch (const SlamError& error) {
    CHECK_FALSE(contains(error.what(), "\n"));
    return error.what();
  }
  return "was mapped";
}

}  // namespace

TEST_CASE("SLAM finds the path that bad odometry does not tell", "[run_slam]") {
  SlamOptions options;
  options.method = GENERATE(SlamMethod::Icp, SlamMethod::Rbpf);
  const bool timed = GENERATE(true, false);
  const KeyFrames key_frames = runSlam(stepsOfPairs(pairedLog(timed)), options);
  CHECK(key_frames.size() >= 4);
  CHECK(key_frames.size() <= drivenPath().size());
  CHECK(offPath(key_frames, drivenPath()) < (options.method == SlamMethod::Icp ? 0.03 : 0.06));
  // By odometry alone the robot would end far from there.
  Pose2D by_odometry;
  const std::vector<Pose2D> path = drivenPath();
  for (size_t i = 1; i < path.size(); ++i) {
    by_odometry = by_odometry + badOdometry(inverse(path[i - 1]) + path[i]);
  }
  CHECK(std::hypot(by_odometry.x - path.back().x, by_odometry.y - path.back().y) > 0.1);
}

TEST_CASE("bare observations are mapped, with and without odometry", "[run_slam]") {
  const bool with_odometry = GENERATE(true, false);
  const KeyFrames key_frames = runSlam(stepsOfObservations(bareLog(1, with_odometry)));
  CHECK(key_frames.size() >= 4);
  CHECK(offPath(key_frames, halfWay()) < 0.03);
}

TEST_CASE("scans of all lidars enter the map", "[run_slam]") {
  const KeyFrames key_frames = runSlam(stepsOfObservations(bareLog(2)));
  int front = 0, rear = 0;
  for (const KeyFrame& key_frame : key_frames) {
    for (const auto& observation : *key_frame.seen) {
      front += observation->sensorLabel == "front" ? 1 : 0;
      rear += observation->sensorLabel == "rear" ? 1 : 0;
    }
  }
  CHECK(front >= 4);
  CHECK(rear >= 4);
  CHECK(offPath(key_frames, halfWay()) < 0.03);
}

TEST_CASE("the same log gives the same key frames", "[run_slam]") {
  SlamOptions options;
  options.method = GENERATE(SlamMethod::Icp, SlamMethod::Rbpf);
  const KeyFrames once = runSlam(stepsOfPairs(pairedLog()), options);
  const KeyFrames again = runSlam(stepsOfPairs(pairedLog()), options);
  REQUIRE(once.size() == again.size());
  for (size_t i = 0; i < once.size(); ++i) {
    CHECK(poseOf(once[i]).x == poseOf(again[i]).x);
    CHECK(poseOf(once[i]).y == poseOf(again[i]).y);
    CHECK(poseOf(once[i]).phi == poseOf(again[i]).phi);
  }
}

TEST_CASE("every step is told, and telling may end the work", "[run_slam]") {
  size_t steps = 0;
  static_cast<void>(runSlam(stepsOfPairs(pairedLog()), {}, [&] { ++steps; }));
  CHECK(steps == drivenPath().size());
  struct Stop {};
  CHECK_THROWS_AS(runSlam(stepsOfPairs(pairedLog()), {}, [] { throw Stop(); }), Stop);
}

TEST_CASE("what cannot be mapped says why in one line", "[run_slam]") {
  SlamOptions rbpf;
  rbpf.method = SlamMethod::Rbpf;
  CHECK(errorOf(stepsOfObservations(bareLog(1, false)), rbpf) ==
        "has no odometry, which RBPF-SLAM needs: take --slam icp");
  SlamOptions nonsense;
  nonsense.settings = "[MappingApplication]\npointsMap_count = 0\n";
  CHECK(errorOf(stepsOfPairs(pairedLog()), nonsense) ==
        "cannot be mapped with these SLAM settings: section [MappingApplication] names no map to "
        "make");
}

TEST_CASE("settings that are given count", "[run_slam]") {
  SlamOptions rare;
  rare.settings = defaultSlamSettings(SlamMethod::Icp);
  const std::string distance = "insertionLinDistance = 0.25", angle = "insertionAngDistance = 8";
  rare.settings.replace(rare.settings.find(distance), distance.size(), "insertionLinDistance = 9");
  rare.settings.replace(rare.settings.find(angle), angle.size(), "insertionAngDistance = 180");
  CHECK(runSlam(stepsOfPairs(pairedLog()), rare).size() == 1);
}
