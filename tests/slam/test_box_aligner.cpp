// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/poses/CPosePDFSOG.h>

#include "sbox/slam/box_aligner.h"
#if __has_include(<mrpt/slam/CGridMapAligner.h>)
#include <mrpt/slam/CGridMapAligner.h>
#define SBOX_HAS_GRID_MAP_ALIGNER
#endif

#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "apps/office.h"
#include "catch.h"
#include "io/contains.h"

using namespace sbox;
using namespace sbox::test;
using mrpt::maps::COccupancyGridMap2D;

namespace {

/// The cells of a map with their corner where MRPT keeps it; no yaw.
COccupancyGridMap2D gridAt(const Map& map, float x_min, float y_min) {
  COccupancyGridMap2D grid;
  const auto cell = static_cast<float>(map.resolution());
  grid.setSize(x_min, x_min + cell * static_cast<float>(map.width()), y_min,
               y_min + cell * static_cast<float>(map.height()), cell);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      grid.setCell(x, y, map.grid.getCell(x, y));
    }
  }
  return grid;
}

/// Two overlapping parts of one floor; m2 lies at (6, 4) in m1.
struct TwoGrids {
  COccupancyGridMap2D m1, m2;
  mrpt::poses::CPose2D m2_in_m1{6, 4, 0};

  TwoGrids() {
    const Map floor = office("floor", 1);
    m1 = gridAt(cutColumns(floor, "a", 0, 400, {}), -1, 2);
    m2 = gridAt(cutColumns(floor, "b", 60, 480, {}), -4, -2);
  }
};

void checkPose(const mrpt::poses::CPose2D& pose, const mrpt::poses::CPose2D& expected) {
  CHECK(pose.x() == Approx(expected.x()).margin(0.1));
  CHECK(pose.y() == Approx(expected.y()).margin(0.1));
  CHECK(std::abs(wrapAngle(pose.phi() - expected.phi())) < 0.02);
}

/// Keeps the tests' output clean.
struct QuietAligner : BoxAligner {
  QuietAligner() { setVerbosityLevel(mrpt::system::LVL_ERROR); }
};

}  // namespace

TEST_CASE("Align gives the pose of the second map in the first", "[box_aligner]") {
  const TwoGrids grids;
  QuietAligner aligner;
  BoxAligner::Result result;
  const auto pose = aligner.Align(&grids.m1, &grids.m2, {}, result);
  REQUIRE(std::dynamic_pointer_cast<mrpt::poses::CPosePDFGaussian>(pose));
  checkPose(pose->getMeanVal(), grids.m2_in_m1);
  CHECK(result.pair.verdict == Verdict::Accepted);
  CHECK(result.executionTime > 0);
  CHECK_FALSE(result.features1.lines.empty());
  CHECK_FALSE(result.features2.boxes.empty());
  const auto covariance = std::get<0>(pose->getCovarianceAndMean());
  CHECK((covariance.asEigen() - result.pair.covariance).norm() < 1e-12);
  CHECK(covariance(0, 0) > 0);
}

TEST_CASE("grids are found inside multi-metric maps", "[box_aligner]") {
  const TwoGrids grids;
  mrpt::maps::CMultiMetricMap m1, m2;
  m1.maps.push_back(mrpt::maps::CSimplePointsMap::Create());
  m1.maps.push_back(std::make_shared<COccupancyGridMap2D>(grids.m1));
  m2.maps.push_back(std::make_shared<COccupancyGridMap2D>(grids.m2));
  QuietAligner aligner;
  checkPose(aligner.Align(&m1, &m2, {})->getMeanVal(), grids.m2_in_m1);
  mrpt::maps::CMultiMetricMap none;
  CHECK_THROWS_AS(aligner.Align(&m1, &none, {}), std::invalid_argument);
  CHECK_THROWS_AS(aligner.Align(nullptr, &m2, {}), std::invalid_argument);
}

TEST_CASE("the form in three dimensions says the same", "[box_aligner]") {
  const TwoGrids grids;
  QuietAligner aligner;
  BoxAligner::Result result;
  const auto pose = aligner.Align3D(&grids.m1, &grids.m2, {}, result);
  REQUIRE(std::dynamic_pointer_cast<mrpt::poses::CPose3DPDFGaussian>(pose));
  const mrpt::poses::CPose3D mean = pose->getMeanVal();
  checkPose(mrpt::poses::CPose2D(mean), grids.m2_in_m1);
  CHECK(mean.z() == 0);
  CHECK(mean.pitch() == 0);
  CHECK(mean.roll() == 0);
  const auto covariance = std::get<0>(pose->getCovarianceAndMean());
  CHECK(covariance(0, 0) == Approx(result.pair.covariance(0, 0)));
  CHECK(covariance(3, 3) == Approx(result.pair.covariance(2, 2)));
}

TEST_CASE("no answer is never a certain zero", "[box_aligner]") {
  const TwoGrids grids;
  const COccupancyGridMap2D hall = gridAt(roundHall("hall"), 0, 0);
  const COccupancyGridMap2D empty(0, 5, 0, 5, 0.05F);
  QuietAligner aligner;
  for (const COccupancyGridMap2D* other : {&hall, &empty}) {
    BoxAligner::Result result;
    const auto pose = aligner.Align(&grids.m1, other, {}, result);
    CHECK(result.pair.verdict != Verdict::Accepted);
    CHECK_FALSE(result.pair.reason.empty());
    const auto covariance = std::get<0>(pose->getCovarianceAndMean());
    for (int i = 0; i < 3; ++i) {
      CHECK(covariance(i, i) >= BoxAligner::no_answer_variance);
    }
  }
}

TEST_CASE("a plain result gets the running time", "[box_aligner]") {
  const TwoGrids grids;
  QuietAligner aligner;
  mrpt::slam::TMetricMapAlignmentResult plain;
  static_cast<void>(aligner.Align(&grids.m1, &grids.m2, {}, plain));
  CHECK(plain.executionTime > 0);
}

TEST_CASE("options come from one section, every key optional", "[box_aligner]") {
  BoxAligner::Options defaults, options;
  mrpt::config::CConfigFileMemory empty(std::string("[other]\nmethod = nonsense\n"));
  options.loadFromConfigFile(empty, "BoxAligner");
  std::ostringstream unchanged, dump;
  defaults.dumpToTextStream(unchanged);
  options.dumpToTextStream(dump);
  CHECK(dump.str() == unchanged.str());
  CHECK(contains(dump.str(), "method = "));
  CHECK_FALSE(contains(dump.str(), "fusion."));

  const mrpt::config::CConfigFileMemory some(
      std::string("[BoxAligner]\nmethod = paper\npaper.cells.free_above = 0.7\n"));
  options.loadFromConfigFile(some, "BoxAligner");
  CHECK(options.merge.method == Method::Paper);
  CHECK(options.merge.paper.states.free_above == Approx(0.7));

  mrpt::config::CConfigFileMemory saved;
  options.saveToConfigFile(saved, "mine");
  BoxAligner::Options back;
  back.loadFromConfigFile(saved, "mine");
  CHECK(back.merge.paper.states.free_above == Approx(0.7));
}

TEST_CASE("options of what comes before and after the matching of a pair are not the aligner's",
          "[box_aligner]") {
  mrpt::config::CConfigFileMemory saved;
  BoxAligner::Options().saveToConfigFile(saved, "mine");
  std::vector<std::string> keys;
  saved.getAllKeys("mine", keys);
  std::set<std::string> stages;
  for (const std::string& key : keys) {
    stages.insert(key.substr(0, key.find('.')));
  }
  CHECK(stages == std::set<std::string>{"features", "matching", "method", "paper", "refinement",
                                        "verification"});

  BoxAligner::Options options;
  const int partners = options.merge.retrieval.partners;
  const mrpt::config::CConfigFileMemory some(
      "[mine]\nretrieval.partners = " + std::to_string(partners + 1) + "\n");
  options.loadFromConfigFile(some, "mine");
  CHECK(options.merge.retrieval.partners == partners);
}

TEST_CASE("a value that cannot be is named with its key", "[box_aligner]") {
  BoxAligner::Options options;
  const mrpt::config::CConfigFileMemory wrong(std::string("[BoxAligner]\nmethod = best\n"));
  try {
    options.loadFromConfigFile(wrong, "BoxAligner");
    FAIL("was taken");
  } catch (const std::runtime_error& error) {
    CHECK(contains(error.what(), "[BoxAligner] method"));
  }
}

#ifdef SBOX_HAS_GRID_MAP_ALIGNER
TEST_CASE("the answer is at least as near to the truth as that of MRPT's own aligner",
          "[box_aligner]") {
  const TwoGrids grids;
  mrpt::maps::CMultiMetricMap m1, m2;
  for (const auto& [map, grid] : {std::pair(&m1, &grids.m1), std::pair(&m2, &grids.m2)}) {
    map->maps.push_back(std::make_shared<COccupancyGridMap2D>(*grid));
    // Its goodness of fit is that of ICP on these points.
    const auto points = mrpt::maps::CSimplePointsMap::Create();
    grid->getAsPointCloud(*points);
    map->maps.push_back(points);
  }
  mrpt::slam::CGridMapAligner theirs;
  theirs.setVerbosityLevel(mrpt::system::LVL_ERROR);
  mrpt::slam::CGridMapAligner::TReturnInfo info;
  QuietAligner ours;
  const auto offBy = [&](const mrpt::poses::CPose2D& pose) {
    return (pose - grids.m2_in_m1).norm();
  };
  const double our_error = offBy(ours.Align(&m1, &m2, {})->getMeanVal());
  const double their_error = offBy(theirs.Align(&m1, &m2, {}, info)->getMeanVal());
  CHECK(our_error < 0.1);
  CHECK(our_error <= their_error + 0.02);
}
#else
TEST_CASE("a comparison with MRPT's own aligner", "[box_aligner]") {
  WARN("skipped: this MRPT has no CGridMapAligner");
}
#endif
