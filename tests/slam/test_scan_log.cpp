// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationComment.h>

#include <limits>

#include "catch.h"
#include "io/contains.h"
#include "io/scratch_folder.h"
#include "io/serialized.h"
#include "sbox/io/file_error.h"
#include "sbox/slam/scan_log.h"
#include "slam/driven_logs.h"

using namespace sbox;
using namespace sbox::test;

namespace {

ScanLog savedAndLoaded(const mrpt::obs::CRawlog& log, const std::string& name = "a.rawlog") {
  const ScratchFolder folder;
  REQUIRE(log.saveToRawLogFile(folder.path(name)));
  return loadScanLog(folder.path(name));
}

std::string errorOf(const std::string& path) {
  try {
    static_cast<void>(loadScanLog(path));
  } catch (const FileError& error) {
    CHECK_FALSE(contains(error.what(), "\n"));
    return error.reason();
  }
  return "was read";
}

Pose2D movementOf(const LogStep& step) {
  return step.moved->getBestMovementEstimation()->poseChange->getMeanVal().asTPose();
}

void checkPose(const Pose2D& pose, const Pose2D& expected) {
  CHECK(pose.x == Approx(expected.x).margin(1e-9));
  CHECK(pose.y == Approx(expected.y).margin(1e-9));
  CHECK(wrapAngle(pose.phi - expected.phi) == Approx(0).margin(1e-9));
}

void insertAction(mrpt::obs::CRawlog& log, const Pose2D& increment) {
  mrpt::obs::CActionRobotMovement2D moved;
  moved.computeFromOdometry(mrpt::poses::CPose2D(increment), {});
  mrpt::obs::CActionCollection actions;
  actions.insert(moved);
  log.insert(actions);
}

void insertFrame(mrpt::obs::CRawlog& log, int scans) {
  mrpt::obs::CSensoryFrame frame;
  for (int i = 0; i < scans; ++i) {
    frame.insert(scanRoom({}, {}));
  }
  log.insert(frame);
}

}  // namespace

TEST_CASE("actions and frames come as they are", "[scan_log]") {
  const std::vector<Pose2D> path = drivenPath();
  const ScanLog log = savedAndLoaded(pairedLog(), GENERATE("a.rawlog", "a.rawlog.gz"));
  CHECK(log.has_odometry);
  REQUIRE(log.steps.size() == path.size());
  for (size_t i = 1; i < path.size(); ++i) {
    checkPose(movementOf(log.steps[i]), badOdometry(inverse(path[i - 1]) + path[i]));
    CHECK(log.steps[i].seen->size() == 1);
  }
}

TEST_CASE("a frame without scans is left out, its movement is not", "[scan_log]") {
  mrpt::obs::CRawlog raw;
  insertAction(raw, {0, 0, 0});
  insertFrame(raw, 1);
  insertAction(raw, {1, 0, M_PI / 2});
  insertFrame(raw, 0);
  insertAction(raw, {1, 0, 0});
  insertFrame(raw, 1);
  const ScanLog log = savedAndLoaded(raw);
  REQUIRE(log.steps.size() == 2);
  checkPose(movementOf(log.steps[1]), {1, 1, M_PI / 2});
}

TEST_CASE("lidars without a name are told apart", "[scan_log]") {
  mrpt::obs::CRawlog raw;
  insertAction(raw, {0, 0, 0});
  insertFrame(raw, 2);
  const ScanLog log = savedAndLoaded(raw);
  const auto& seen = *log.steps.at(0).seen;
  CHECK((*seen.begin())->sensorLabel == "lidar 1");
  CHECK((*(seen.begin() + 1))->sensorLabel == "lidar 2");
}

TEST_CASE("odometry is interpolated to the time of bare scans", "[scan_log]") {
  const std::vector<Pose2D> path = drivenPath();
  const ScanLog log = savedAndLoaded(bareLog());
  CHECK(log.has_odometry);
  REQUIRE(log.steps.size() == path.size() - 1);
  // Half of one increment and half of the next; all are equal.
  const Pose2D increment = badOdometry(inverse(path[0]) + path[1]);
  const double turn = increment.phi / 2;
  const double ahead = increment.x / 2 * (1 + std::cos(increment.phi));
  const double aside = increment.x / 2 * std::sin(increment.phi);
  const Pose2D expected{ahead * std::cos(turn) + aside * std::sin(turn),
                        aside * std::cos(turn) - ahead * std::sin(turn), increment.phi};
  for (size_t i = 1; i < log.steps.size(); ++i) {
    checkPose(movementOf(log.steps[i]), expected);
  }
}

TEST_CASE("bare scans of two lidars at one time make one step", "[scan_log]") {
  const ScanLog log = savedAndLoaded(bareLog(2));
  REQUIRE(log.steps.size() == drivenPath().size() - 1);
  CHECK(log.steps[3].seen->size() == 2);
}

TEST_CASE("a log may have no odometry", "[scan_log]") {
  const ScanLog log = savedAndLoaded(bareLog(1, false));
  CHECK_FALSE(log.has_odometry);
  REQUIRE(log.steps.size() == drivenPath().size() - 1);
  CHECK(log.steps[2].moved->size() == 0);
}

TEST_CASE("a log that holds no scan says what it holds", "[scan_log]") {
  const ScratchFolder folder;
  mrpt::obs::CRawlog raw;
  for (int i = 0; i < 3; ++i) {
    raw.insert(std::static_pointer_cast<mrpt::serialization::CSerializable>(
        std::make_shared<mrpt::obs::CObservationOdometry>()));
  }
  REQUIRE(raw.saveToRawLogFile(folder.path("a.rawlog")));
  const std::string reason = errorOf(folder.path("a.rawlog"));
  CHECK(contains(reason, "holds no 2D lidar scan to make a map of, but 3 "));
  CHECK(contains(reason, "CObservationOdometry"));
}

TEST_CASE("what comes before the damage is taken", "[scan_log]") {
  const ScratchFolder folder;
  REQUIRE(pairedLog().saveToRawLogFile(folder.path("whole.rawlog")));
  const std::string bytes = folder.read("whole.rawlog");
  folder.write("cut.rawlog", bytes.substr(0, bytes.size() * 2 / 3));
  const ScanLog whole = loadScanLog(folder.path("whole.rawlog"));
  const ScanLog cut = loadScanLog(folder.path("cut.rawlog"));
  CHECK_FALSE(whole.cut_off);
  CHECK(cut.cut_off);
  CHECK(cut.steps.size() > 2);
  CHECK(cut.steps.size() < whole.steps.size());
}

TEST_CASE("a file that is no rawlog is refused in one line", "[scan_log]") {
  const ScratchFolder folder;
  folder.write("text.rawlog", "hello, this is no rawlog");
  folder.write("empty.rawlog", "");
  CHECK(errorOf(folder.path("text.rawlog")) == "cannot be read as a rawlog");
  CHECK(errorOf(folder.path("empty.rawlog")) == "is empty");
  CHECK(errorOf(folder.path("missing.rawlog")) == "no such file");
}

TEST_CASE("a frame that lacks an observation is damage", "[scan_log]") {
  const ScratchFolder folder;
  const mrpt::obs::CRawlog raw = pairedLog();
  const auto& scan = **raw.getAsObservations(3)->begin();
  std::string bytes;
  for (size_t i = 0; i < raw.size(); ++i) {
    bytes += serialized(raw.getAsGeneric(i).get());
  }
  folder.write("entries.rawlog", withoutObject(bytes, scan));
  const ScanLog log = loadScanLog(folder.path("entries.rawlog"));
  CHECK(log.cut_off);
  CHECK(log.steps.size() == 1);
  // All entries may be one object.
  folder.write("one.rawlog", withoutObject(serialized(&raw), scan));
  CHECK(errorOf(folder.path("one.rawlog")) == "cannot be read as a rawlog");
}

TEST_CASE("a log with a scan that cannot be is refused", "[scan_log]") {
  mrpt::obs::CRawlog raw;
  insertAction(raw, {0, 0, 0});
  mrpt::obs::CSensoryFrame frame;
  const auto scan = scanRoom({}, {});
  scan->sensorPose = {0, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0, 0};
  frame.insert(scan);
  raw.insert(frame);
  const ScratchFolder folder;
  REQUIRE(raw.saveToRawLogFile(folder.path("a.rawlog")));
  CHECK(errorOf(folder.path("a.rawlog")) ==
        "is damaged: the pose, angles or ranges of a scan make no sense");
}

TEST_CASE("a log whose odometry makes no sense is refused", "[scan_log]") {
  mrpt::obs::CRawlog raw;
  insertAction(raw, {1e30, 0, 0});
  insertFrame(raw, 1);
  const ScratchFolder folder;
  REQUIRE(raw.saveToRawLogFile(folder.path("a.rawlog")));
  CHECK(errorOf(folder.path("a.rawlog")) ==
        "is damaged: a movement of its odometry makes no sense");
}

TEST_CASE("the largest number there is for a beam without an echo has no end", "[scan_log]") {
  mrpt::obs::CRawlog raw;
  insertAction(raw, {0, 0, 0});
  mrpt::obs::CSensoryFrame frame;
  const auto scan = scanRoom({}, {});
  const float measured = scan->getScanRange(200);
  scan->setScanRange(100, std::numeric_limits<float>::max());
  frame.insert(scan);
  raw.insert(frame);
  const ScanLog log = savedAndLoaded(raw);
  const auto& loaded =
      dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(**log.steps.at(0).seen->begin());
  CHECK(loaded.getScanRange(100) == std::numeric_limits<float>::infinity());
  CHECK(loaded.getScanRange(200) == measured);
}
