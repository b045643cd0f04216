// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/slam.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDF.h>
#include <mrpt/random/RandomGenerators.h>
#include <mrpt/slam/CMetricMapBuilderICP.h>
#include <mrpt/slam/CMetricMapBuilderRBPF.h>

#include <deque>
#include <stdexcept>

#include "sbox-dataset/rawlog_file.h"

namespace sbox::paper {
namespace {

using dataset::Run;

// A points map to match against; the grid is made afterwards, at the poses found. Matching is
// tight: with MRPT's usual thresholds points at the edge of what is mapped pair with the map's last
// points and pull, and a map of 20 m comes out bent by 0.1 m whatever the odometry.
constexpr const char* kIcpSettings = R"(
[ICP]
maxIterations = 60
minAbsStep_trans = 1e-5
minAbsStep_rot = 1e-5
thresholdDist = 0.1
thresholdAng_DEG = 0.1
ALFA = 0.7
smallestThresholdDist = 0.03
onlyClosestCorrespondences = true
ICP_algorithm = icpClassic
corresponding_points_decimation = 2
[MappingApplication]
localizationLinDistance = 0.02
localizationAngDistance = 0.5
insertionLinDistance = 0.5
insertionAngDistance = 25
minICPgoodnessToAccept = 0.35
matchAgainstTheGrid = 0
occupancyGrid_count = 0
pointsMap_count = 1
likelihoodMapSelection = -1
[MappingApplication_pointsMap_00_insertOpts]
minDistBetweenLaserPoints = 0.05
fuseWithExisting = false
isPlanarMap = 1
)";

// Each step updates the filter, so that the path has a pose a step; each half metre adds to the
// maps, as more is slow. PF_algorithm 2: the optimal proposal, approximated by matching the scan to
// the particle's map; MRPT adds noise of 0.1 degrees or more to each match, which only sharp
// weights take out again.
constexpr const char* kRbpfSettings = R"(
[MappingApplication]
insertionLinDistance = 0.5
insertionAngDistance_deg = 25
localizeLinDistance = 0
localizeAngDistance_deg = 0
PF_algorithm = 2
adaptiveSampleSize = 0
resamplingMethod = 0
sampleSize = 6
BETA = 0.50
occupancyGrid_count = 0
pointsMap_count = 1
likelihoodMapSelection = -1
pfOptimalProposal_mapSelection = 3
ICPGlobalAlign_MinQuality = 0.10
ICP_algorithm = 1
maxIterations = 60
thresholdDist = 0.10
thresholdAng_DEG = 0.1
ALFA = 0.70
smallestThresholdDist = 0.03
onlyClosestCorrespondences = 1
[MappingApplication_pointsMap_00_insertOpts]
minDistBetweenLaserPoints = 0.05
fuseWithExisting = 0
isPlanarMap = 1
[MappingApplication_pointsMap_00_likelihoodOpts]
max_corr_distance = 0.2
sigma_dist = 0.02
)";

/// Feeds the builder a run, a step at a time.
template <typename AfterStep>
void process(mrpt::slam::CMetricMapBuilder& builder, const Run& run, const AfterStep& after_step) {
  mrpt::obs::CRawlog log = dataset::rawlogOf(run);
  for (size_t i = 0; i < run.size(); ++i) {
    builder.processActionObservation(*log.getAsAction(2 * i), *log.getAsObservations(2 * i + 1));
    after_step(i);
  }
}

}  // namespace

Run slamByIcp(const Run& odometry_run) {
  mrpt::slam::CMetricMapBuilderICP builder;
  builder.setVerbosityLevel(mrpt::system::LVL_ERROR);
  const mrpt::config::CConfigFileMemory settings{std::string(kIcpSettings)};
  builder.ICP_options.loadFromConfigFile(settings, "MappingApplication");
  builder.ICP_params.loadFromConfigFile(settings, "ICP");
  builder.initialize();
  Run corrected = odometry_run;
  process(builder, odometry_run, [&](size_t i) {
    mrpt::poses::CPose3D pose;
    builder.getCurrentPoseEstimation()->getMean(pose);
    corrected[i].pose_in_map = {pose.x(), pose.y(), pose.yaw()};
  });
  return corrected;
}

Run slamByRbpf(const Run& odometry_run, std::uint32_t seed) {
  mrpt::random::getRandomGenerator().randomize(seed);
  const mrpt::config::CConfigFileMemory settings{std::string(kRbpfSettings)};
  mrpt::slam::CMetricMapBuilderRBPF::TConstructionOptions options;
  options.loadFromConfigFile(settings, "MappingApplication");
  options.verbosity_level = mrpt::system::LVL_ERROR;
  mrpt::slam::CMetricMapBuilderRBPF builder(options);
  builder.mapPDF.setVerbosityLevel(mrpt::system::LVL_ERROR);
  builder.initialize();
  process(builder, odometry_run, [](size_t) {});
  std::deque<mrpt::math::TPose3D> path;
  builder.getCurrentMostLikelyPath(path);
  // It starts with the pose before the first step.
  if (path.size() != odometry_run.size() + 1) {
    throw std::runtime_error("RBPF-SLAM gave " + std::to_string(path.size()) + " poses for " +
                             std::to_string(odometry_run.size()) + " scans");
  }
  path.pop_front();
  Run corrected = odometry_run;
  for (size_t i = 0; i < corrected.size(); ++i) {
    corrected[i].pose_in_map = {path[i].x, path[i].y, path[i].yaw};
  }
  return corrected;
}

}  // namespace sbox::paper
