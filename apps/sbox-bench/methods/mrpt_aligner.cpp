// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/methods/mrpt_aligner.h"

#if __has_include(<mrpt/slam/CGridMapAligner.h>)
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPosePDFSOG.h>
#include <mrpt/random/RandomGenerators.h>
#include <mrpt/slam/CGridMapAligner.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "sbox/core/stopwatch.h"

namespace sbox::bench {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CSimplePointsMap;
using mrpt::poses::CPosePDFSOG;

struct GridAndPoints {
  COccupancyGridMap2D grid;
  CSimplePointsMap walls;  ///< In the grid's own frame. Without them the aligner skips its ICP.
  Pose2D grid_in_map;      ///< MRPT's frame of the grid in that of the map.
};

GridAndPoints gridAndPoints(const Map& map) {
  GridAndPoints result;
  result.grid = map.grid;
  result.grid.getAsPointCloud(result.walls);
  const Pose2D corner_in_grid(map.grid.getXMin(), map.grid.getYMin(), 0);
  result.grid_in_map = map.corner_in_map + inverse(corner_in_grid);
  return result;
}

/// A copy, as MRPT builds search trees and caches inside of maps that it is only to read.
mrpt::maps::CMultiMetricMap multiMap(const GridAndPoints& map) {
  mrpt::maps::CMultiMetricMap result;
  result.maps.push_back(std::make_shared<COccupancyGridMap2D>(map.grid));
  result.maps.push_back(std::make_shared<CSimplePointsMap>(map.walls));
  return result;
}

PairResult alignGrids(const GridAndPoints& a, const GridAndPoints& b) {
  const Stopwatch stopwatch;
  PairResult result;
  if (a.walls.empty() || b.walls.empty()) {
    result.reason = "a map has no wall";
    return result;
  }
  if (a.grid.getResolution() != b.grid.getResolution()) {
    result.reason = "the aligner takes maps of one cell size only";
    return result;
  }
  mrpt::random::getRandomGenerator().randomize(1);  // Each thread has its own.
  mrpt::slam::CGridMapAligner aligner;
  aligner.setVerbosityLevel(mrpt::system::LVL_ERROR);
  mrpt::slam::CGridMapAligner::TReturnInfo info;
  const mrpt::maps::CMultiMetricMap map_a = multiMap(a), map_b = multiMap(b);
  const auto modes =
      std::dynamic_pointer_cast<CPosePDFSOG>(aligner.Align(&map_a, &map_b, {}, info));
  if (modes && !modes->empty()) {
    mrpt::math::CMatrixDouble33 covariance;
    mrpt::poses::CPose2D mean;
    modes->getMostLikelyCovarianceAndMean(covariance, mean);
    result.has_pose = true;
    result.pose_b_in_a = a.grid_in_map + (mean.asTPose() + inverse(b.grid_in_map));
    result.verdict = Verdict::Accepted;
    double sum = 0, most = 0;
    for (const CPosePDFSOG::TGaussianMode& mode : *modes) {
      sum += std::exp(mode.log_w);
      most = std::max(most, std::exp(mode.log_w));
    }
    result.confidence = most / sum;
  }
  result.reason = std::to_string(modes ? modes->size() : 0) + " modes are left of " +
                  std::to_string(info.icp_goodness_all_sog_modes.size());
  result.seconds.matching = stopwatch.seconds();
  return result;
}

}  // namespace

std::optional<Method> mrptMethod() { return makeMethod("mrpt", gridAndPoints, alignGrids); }

}  // namespace sbox::bench
#else
namespace sbox::bench {

std::optional<Method> mrptMethod() { return std::nullopt; }

}  // namespace sbox::bench
#endif
