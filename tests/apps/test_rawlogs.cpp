// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From two robots' logs to a merged map in one command, and on: MRPT's particle-filter localiser
// finds the path of one robot on the merged map.
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/random/RandomGenerators.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "adjustment/pose_error.h"
#include "apps/check_contains.h"
#include "apps/command.h"
#include "catch.h"
#include "io/serialized.h"
#include "sbox-dataset/drive.h"
#include "sbox-dataset/world.h"
#include "sbox/adjustment/scan_agreement.h"
#include "sbox/io/load_map.h"
#include "sbox/io/simplemap_file.h"
#include "sbox/slam/scan_log.h"

using namespace sbox;
using namespace sbox::test;
using nlohmann::json;

namespace {

/// Entries of a log of actions and frames, untimed as many converted logs are.
void saveRun(const dataset::Run& run, const std::string& path) {
  mrpt::obs::CRawlog log;
  for (size_t i = 0; i < run.size(); ++i) {
    mrpt::obs::CActionRobotMovement2D moved;
    const Pose2D increment =
        i == 0 ? Pose2D() : inverse(run[i - 1].pose_in_map) + run[i].pose_in_map;
    moved.computeFromOdometry(mrpt::poses::CPose2D(increment), {});
    mrpt::obs::CActionCollection actions;
    actions.insert(moved);
    log.insert(actions);
    mrpt::obs::CSensoryFrame frame;
    frame.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(run[i].scan));
    log.insert(frame);
  }
  REQUIRE(log.saveToRawLogFile(path));
}

/// Two robots that drove through the shipped office, and where the second started as seen from
/// where the first did.
struct Robots {
  dataset::Run a, b;
  Pose2D pose_b_in_a;

  Robots() {
    const std::string folder = std::string(SBOX_DATASETS) + "/office/";
    const dataset::World world = dataset::loadWorld(folder + "office.world");
    dataset::DriveOptions options;
    options.beams = 181;
    options.step_length = 0.2;
    a = dataset::drive(world, dataset::loadPath(folder + "robot_a.path"), options);
    options.seed = 2;
    b = dataset::drive(world, dataset::loadPath(folder + "robot_b.path"), options);
    pose_b_in_a = inverse(a.front().pose_in_world) + b.front().pose_in_world;
  }
};

std::vector<float> rangesOf(const mrpt::obs::CObservation2DRangeScan& scan) {
  std::vector<float> ranges;
  for (size_t i = 0; i < scan.getScanSize(); ++i) {
    ranges.push_back(scan.getScanRange(i));
  }
  return ranges;
}

/// How far key frames lie from where they were in truth, after the best rigid fit; metres. The
/// noise of its scan tells each.
double errorOf(const KeyFrames& key_frames, const Robots& robots) {
  std::map<std::vector<float>, Pose2D> truth;
  for (const dataset::Run* run : {&robots.a, &robots.b}) {
    for (const dataset::RunStep& step : *run) {
      truth[rangesOf(step.scan)] = step.pose_in_world;
    }
  }
  std::vector<Pose2D> poses, true_poses;
  for (const KeyFrame& key_frame : key_frames) {
    const auto scan = key_frame.seen->getObservationByClass<mrpt::obs::CObservation2DRangeScan>();
    poses.emplace_back(key_frame.robot_in_map->getMeanVal().asTPose());
    true_poses.push_back(truth.at(rangesOf(*scan)));
  }
  return poseError(poses, true_poses);
}

/// The particle filter's estimate after each of every `stride`-th step, from no idea where it is.
std::vector<Pose2D> localise(const Map& map, const ScanLog& log, size_t stride,
                             std::uint32_t seed) {
  mrpt::random::getRandomGenerator().randomize(seed);
  auto grid = std::make_shared<mrpt::maps::COccupancyGridMap2D>();
  // MRPT's own place of the cells: as its programs see them in a .gridmap.
  const double cell = map.resolution();
  grid->setSize(static_cast<float>(map.corner_in_map.x),
                static_cast<float>(map.corner_in_map.x + cell * map.width()),
                static_cast<float>(map.corner_in_map.y),
                static_cast<float>(map.corner_in_map.y + cell * map.height()),
                static_cast<float>(cell));
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      grid->setCell(x, y, map.grid.getCell(x, y));
    }
  }
  auto& likelihood = grid->likelihoodOptions;
  likelihood.likelihoodMethod = mrpt::maps::COccupancyGridMap2D::lmLikelihoodField_Thrun;
  likelihood.LF_decimation = 10;
  likelihood.LF_stdHit = 0.2F;
  likelihood.LF_maxCorrsDistance = 0.5F;
  likelihood.LF_zHit = 0.95F;
  likelihood.LF_zRandom = 0.05F;

  mrpt::slam::CMonteCarloLocalization2D particles(1);
  particles.options.metricMap = grid;
  particles.options.KLD_params.KLD_minSampleSize = 300;
  particles.options.KLD_params.KLD_maxSampleSize = 20000;
  particles.options.KLD_params.KLD_binSize_XY = 0.2;
  particles.options.KLD_params.KLD_binSize_PHI = 0.17;
  particles.resetUniformFreeSpace(grid.get(), 0.7, 20000);
  mrpt::bayes::CParticleFilter filter;
  filter.setVerbosityLevel(mrpt::system::LVL_ERROR);
  filter.m_options.adaptiveSampleSize = true;
  std::vector<Pose2D> estimates;
  mrpt::poses::CPose2D moved_since;
  for (size_t i = 0; i < log.steps.size(); ++i) {
    moved_since += log.steps[i].moved->getBestMovementEstimation()->poseChange->getMeanVal();
    if (i % stride != 0) {
      continue;
    }
    mrpt::obs::CActionRobotMovement2D moved;
    moved.computeFromOdometry(moved_since, {});
    mrpt::obs::CActionCollection actions;
    actions.insert(moved);
    filter.executeOn(particles, &actions, log.steps[i].seen.get());
    moved_since = mrpt::poses::CPose2D();
    estimates.push_back(particles.getMeanVal().asTPose());
  }
  return estimates;
}

}  // namespace

TEST_CASE("two logs become one map, in which a robot finds its way") {
  const Robots robots;
  const ScratchFolder folder;
  saveRun(robots.a, folder / "a.rawlog");
  saveRun(robots.b, folder / "b.rawlog");
  const Outcome outcome =
      runMerge(folder.path(), {"--in", "a.rawlog", "b.rawlog", "--fusion", "observations",
                               "--simplemap", "all.simplemap", "--report", "r.json"});
  CHECK(outcome.err.empty());
  REQUIRE(outcome.exit_code == 0);
  CHECK(listing(folder.path()) ==
        std::vector<std::string>{"a.rawlog", "all.simplemap", "b.rawlog", "merged.gridmap",
                                 "merged.png", "merged_a.gridmap", "merged_a.png",
                                 "merged_a.simplemap", "merged_b.gridmap", "merged_b.png",
                                 "merged_b.simplemap", "r.json"});

  const json pose = json::parse(contents(folder / "r.json"))["pairs"][0]["pose"];
  CHECK(std::hypot(pose["x"].get<double>() - robots.pose_b_in_a.x,
                   pose["y"].get<double>() - robots.pose_b_in_a.y) <
        0.5);  // with what SLAM drifted in both
  CHECK(std::abs(wrapAngle(pose["phi"].get<double>() - robots.pose_b_in_a.phi)) < 2 * M_PI / 180);

  const KeyFrames all = loadKeyFrames(folder / "all.simplemap");
  const KeyFrames of_a = loadKeyFrames(folder / "merged_a.simplemap");
  const KeyFrames of_b = loadKeyFrames(folder / "merged_b.simplemap");
  CHECK(all.size() == of_a.size() + of_b.size());

  // The kept maps merge to the same map, without SLAM.
  const Outcome again =
      runMerge(folder.path(), {"--in", "merged_a.simplemap", "merged_b.simplemap", "--out",
                               "cells.gridmap", "--simplemap", "placed.simplemap"});
  REQUIRE(again.exit_code == 0);
  const Map merged = loadMap(folder / "merged.gridmap");
  // Adjusting what SLAM bent brings the key frames nearer to the truth ...
  const KeyFrames placed = loadKeyFrames(folder / "placed.simplemap");
  CHECK(errorOf(all, robots) < 0.5 * errorOf(placed, robots));
  // ... and made anew of them the map is sharper than the cells' fusion.
  CHECK(scanAgreement(all, merged) > scanAgreement(placed, loadMap(folder / "cells.gridmap")));

  const ScanLog log = loadScanLog(folder / "b.rawlog");
  REQUIRE(log.steps.size() == robots.b.size());
  constexpr size_t stride = 3;
  // From no idea where it is, a filter of this many particles settles in a like room now and then.
  int found = 0;
  for (std::uint32_t seed = 1; seed <= 6 && found < 2; ++seed) {
    const std::vector<Pose2D> estimates = localise(merged, log, stride, seed);
    size_t right = 0;
    for (size_t i = estimates.size() / 2; i < estimates.size(); ++i) {
      const Pose2D truth =
          inverse(robots.a.front().pose_in_world) + robots.b[i * stride].pose_in_world;
      right += std::hypot(estimates[i].x - truth.x, estimates[i].y - truth.y) < 0.3 &&
                       std::abs(wrapAngle(estimates[i].phi - truth.phi)) < 5 * M_PI / 180
                   ? 1
                   : 0;
    }
    found += right >= (estimates.size() - estimates.size() / 2) * 9 / 10 ? 1 : 0;
  }
  CHECK(found == 2);
}

TEST_CASE("a log that cannot be mapped ends in 1 and says why") {
  const ScratchFolder folder;
  mrpt::obs::CRawlog log;
  mrpt::obs::CActionRobotMovement2D moved;
  moved.computeFromOdometry(mrpt::poses::CPose2D(1, 0, 0), {});
  mrpt::obs::CActionCollection actions;
  actions.insert(moved);
  log.insert(actions);
  REQUIRE(log.saveToRawLogFile(folder / "blind.rawlog"));
  const std::vector<std::string> before = listing(folder.path());
  const Outcome outcome = runMerge(folder.path(), {"--in", "blind.rawlog", "blind.rawlog"});
  CHECK(outcome.exit_code == 1);
  checkContains(outcome.err, "sbox-merge: blind.rawlog: holds no 2D lidar scan to make a map of");
  CHECK(listing(folder.path()) == before);
}

TEST_CASE("scans are asked of every map where they are needed") {
  const ScratchFolder folder;
  saveKeyFrames(dataset::keyFramesOf(Robots().a), folder / "a.simplemap");
  for (const std::vector<std::string>& wish :
       {std::vector<std::string>{"--fusion", "observations"}, {"--simplemap", "all.simplemap"}}) {
    std::vector<std::string> arguments{"--in", "a.simplemap",
                                       std::string(SBOX_DATASETS) + "/office/robot_b.gridmap.gz"};
    arguments.insert(arguments.end(), wish.begin(), wish.end());
    const Outcome outcome = runMerge(folder.path(), arguments);
    CHECK(outcome.exit_code == 1);
    checkContains(outcome.err, "robot_b.gridmap.gz: holds no scans, which " + wish[0]);
  }
}

TEST_CASE("wrong choices of SLAM end in 2") {
  const ScratchFolder folder;
  const Outcome outcome =
      runMerge(folder.path(), {"--in", "a.rawlog", "b.rawlog", "--slam", "gmapping"});
  CHECK(outcome.exit_code == 2);
  checkContains(outcome.err, "--slam must be icp or rbpf, not gmapping");
}

TEST_CASE("a log whose reading would end the program is an error line") {
  const ScratchFolder folder;
  mrpt::obs::CActionRobotMovement2D moved;
  moved.computeFromOdometry(mrpt::poses::CPose2D(1, 0, 0), {});
  mrpt::obs::CActionCollection actions;
  actions.insert(moved);
  std::ofstream(folder / "a.rawlog") << withoutObject(serialized(&actions), moved);
  std::ofstream(folder / "b.rawlog") << "no log";
  const Outcome outcome = runMerge(folder.path(), {"--in", "a.rawlog", "b.rawlog"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.empty());
  checkContains(outcome.err, "a.rawlog: ");
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(listing(folder.path()) == std::vector<std::string>{"a.rawlog", "b.rawlog"});
}
