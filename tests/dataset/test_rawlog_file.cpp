// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CRawlog.h>

#include <fstream>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox-dataset/drive.h"
#include "sbox-dataset/logged_runs.h"
#include "sbox-dataset/rawlog_file.h"

using namespace sbox;
using namespace sbox::dataset;

TEST_CASE("a rawlog holds a run's scans and its odometry, and the truth lies beside it",
          "[rawlog]") {
  World world;
  world.walls = {{{-2, -2}, {2, -2}}, {{2, -2}, {2, 2}}, {{2, 2}, {-2, 2}}, {{-2, 2}, {-2, -2}}};
  const Run run = drive(world, {{1, 1, 0.5}, {{1, -1}, {-1, -1}}});
  const ScratchFolder scratch;
  saveRawlog(run, scratch.path("r.rawlog"));
  saveTruePoses(run, scratch.path("r.gt"));

  const LoggedScans log(scratch.path("r.rawlog"));
  REQUIRE(log.size() == run.size());
  CHECK(log.scan(3).getScanRange(7) == run[3].scan.getScanRange(7));
  CHECK(log.scan(1).timestamp > log.scan(0).timestamp);
  mrpt::obs::CRawlog raw;
  REQUIRE(raw.loadFromRawLogFile(scratch.path("r.rawlog")));
  mrpt::poses::CPose2D odometry;
  for (size_t i = 0; i < raw.size(); i += 2) {
    const auto movement = raw.getAsAction(i)->getActionByClass<mrpt::obs::CActionRobotMovement2D>();
    REQUIRE(movement);
    odometry = odometry + movement->rawOdometryIncrementReading;
  }
  CHECK(odometry.x() == Approx(run.back().pose_in_map.x).margin(1e-6));
  CHECK(odometry.y() == Approx(run.back().pose_in_map.y).margin(1e-6));

  const std::vector<Pose2D> poses = loadPoses(scratch.path("r.gt"));
  REQUIRE(poses.size() == run.size());
  CHECK(poses.back().x == Approx(-1).margin(1e-6));
}
