// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/box_aligner.h"

#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/poses/CPosePDFSOG.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sbox/core/stopwatch.h"
#include "sbox/match_maps.h"

namespace sbox {
namespace {

using mrpt::maps::CMetricMap;
using mrpt::maps::COccupancyGridMap2D;
using mrpt::poses::CPose2D;
using mrpt::poses::CPosePDFGaussian;
using mrpt::poses::CPosePDFSOG;

const COccupancyGridMap2D& gridOf(const CMetricMap* map) {
  if (const auto* grid = dynamic_cast<const COccupancyGridMap2D*>(map)) {
    return *grid;
  }
  if (const auto* maps = dynamic_cast<const mrpt::maps::CMultiMetricMap*>(map)) {
    if (const auto grid = maps->mapByClass<COccupancyGridMap2D>()) {
      return *grid;
    }
  }
  throw std::invalid_argument("BoxAligner needs occupancy grids, or multi-metric maps with one");
}

Map toMap(const COccupancyGridMap2D& grid, const char* name) {
  Map map;
  map.name = name;
  map.grid = grid;
  map.corner_in_map = {grid.getXMin(), grid.getYMin(), 0};
  return map;
}

CPosePDFSOG::TGaussianMode mode(const Candidate& candidate, const PoseCovariance& covariance) {
  constexpr double least_confidence = 1e-9;
  CPosePDFSOG::TGaussianMode gaussian;
  gaussian.mean = CPose2D(candidate.pose_b_in_a);
  gaussian.cov = covariance;
  gaussian.log_w = std::log(std::max(candidate.confidence, least_confidence));
  return gaussian;
}

mrpt::poses::CPosePDF::Ptr distribution(const PairResult& pair) {
  if (pair.verdict == Verdict::Ambiguous && !pair.alternatives.empty()) {
    auto modes = std::make_shared<CPosePDFSOG>();
    modes->push_back(mode({pair.pose_b_in_a, pair.confidence}, pair.covariance));
    for (const Candidate& other : pair.alternatives) {
      modes->push_back(mode(other, pair.covariance));
    }
    modes->normalizeWeights();
    return modes;
  }
  auto gaussian = std::make_shared<CPosePDFGaussian>();
  gaussian->mean = pair.has_pose ? CPose2D(pair.pose_b_in_a) : CPose2D();
  if (pair.verdict == Verdict::Accepted) {
    gaussian->cov = pair.covariance;
  } else {
    gaussian->cov.setDiagonal(3, BoxAligner::no_answer_variance);
  }
  return gaussian;
}

}  // namespace

BoxAligner::BoxAligner() { setLoggerName("BoxAligner"); }

mrpt::poses::CPosePDF::Ptr BoxAligner::AlignPDF(
    const CMetricMap* m1, const CMetricMap* m2, const CPosePDFGaussian& /*initial_estimate*/,
    mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> out_info) {
  const Stopwatch stopwatch;
  MatchedPair matched = matchMaps(toMap(gridOf(m1), "m1"), toMap(gridOf(m2), "m2"), options.merge);
  if (matched.result.verdict != Verdict::Accepted) {
    logStr(mrpt::system::LVL_WARN,
           std::string(toString(matched.result.verdict)) + ": " + matched.result.reason);
  }
  mrpt::poses::CPosePDF::Ptr pose = distribution(matched.result);
  if (out_info.has_value()) {
    mrpt::slam::TMetricMapAlignmentResult& info = out_info.value().get();
    info.executionTime = stopwatch.seconds();
    if (auto* result = dynamic_cast<Result*>(&info)) {
      result->pair = std::move(matched.result);
      result->features1 = std::move(matched.features_a);
      result->features2 = std::move(matched.features_b);
    }
  }
  return pose;
}

mrpt::poses::CPose3DPDF::Ptr BoxAligner::Align3DPDF(
    const CMetricMap* m1, const CMetricMap* m2,
    const mrpt::poses::CPose3DPDFGaussian& initial_estimate,
    mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> out_info) {
  const auto planar = AlignPDF(m1, m2, CPosePDFGaussian(CPose2D(initial_estimate.mean)), out_info);
  return mrpt::poses::CPose3DPDF::Ptr(mrpt::poses::CPose3DPDF::createFrom2D(*planar));
}

}  // namespace sbox
