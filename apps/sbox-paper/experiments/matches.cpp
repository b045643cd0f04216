// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/experiments/matches.h"

#include <algorithm>
#include <array>
#include <limits>

#include "sbox-bench/methods/keypoints.h"
#include "sbox/core/parallel.h"
#include "sbox/merge.h"

namespace sbox::paper {
namespace {

constexpr double kTolerance = 0.5;

/// Corners of matched boxes, each with the corner of the other box that the cyclic shift of least
/// distance under the truth pairs it with: which shift a method meant is not in its result.
MatchCount countBoxes(const Map& a, const Map& b, const MergeOptions& options,
                      const Pose2D& pose_b_in_a, double tolerance) {
  const MergeResult merged = mergeMaps({a, b}, options);
  const auto& boxes_a = merged.maps[0].features.boxes;
  const auto& boxes_b = merged.maps[1].features.boxes;
  MatchCount count;
  for (const auto& [index_a, index_b] : merged.pairs[0].result.matched_boxes) {
    const std::array<Point2D, 4>& box_a = boxes_a[static_cast<size_t>(index_a)];
    const std::array<Point2D, 4>& box_b = boxes_b[static_cast<size_t>(index_b)];
    int most = 0;
    for (size_t shift = 0; shift < 4; ++shift) {
      int near = 0;
      for (size_t i = 0; i < 4; ++i) {
        const Point2D in_a = pose_b_in_a.composePoint(box_b[(i + shift) % 4]);
        near += (in_a - box_a[i]).norm() <= tolerance ? 1 : 0;
      }
      most = std::max(most, near);
    }
    count.matches += 4;
    count.right += most;
  }
  return count;
}

MatchCount countKeypoints(const Map& a, const Map& b, bench::KeypointKind kind,
                          const Pose2D& pose_b_in_a, double tolerance) {
  bench::KeypointOptions options;
  options.kind = kind;
  MatchCount count;
  for (const bench::PointMatch& match : bench::mutualKeypointMatches(a, b, options)) {
    ++count.matches;
    count.right += (pose_b_in_a.composePoint(match.in_b) - match.in_a).norm() <= tolerance ? 1 : 0;
  }
  return count;
}

}  // namespace

std::vector<PairMatches> countMatches(const bench::LoadedFolder& loaded, int threads) {
  std::vector<PairMatches> result;
  std::vector<size_t> indices;
  for (size_t i = 0; i < loaded.folder.pairs.size(); ++i) {
    if (!loaded.folder.pairs[i].negative) {
      indices.push_back(i);
    }
  }
  result.resize(indices.size());
  parallelFor(static_cast<int>(indices.size()), threads, [&](int i) {
    const size_t index = indices[static_cast<size_t>(i)];
    const bench::AnnotatedPair& pair = loaded.folder.pairs[index];
    const Map& a = loaded.maps[static_cast<size_t>(loaded.map_of_pair[index].first)];
    const Map& b = loaded.maps[static_cast<size_t>(loaded.map_of_pair[index].second)];
    const double resolution = loaded.folder.resolution;
    const Pose2D truth = bench::poseFromCorners(bench::trueCornerAInCornerB(pair, resolution),
                                                a.corner_in_map, b.corner_in_map);
    PairMatches& counts = result[static_cast<size_t>(i)];
    counts.group = pair.group;
    counts.a = pair.a;
    counts.b = pair.b;
    counts.tolerance = kTolerance + pair.floor_cells * resolution;
    MergeOptions options;
    options.threads = 1;
    counts.boxes = countBoxes(a, b, options, truth, counts.tolerance);
    options.method = Method::Paper;
    counts.paper = countBoxes(a, b, options, truth, counts.tolerance);
    counts.orb = countKeypoints(a, b, bench::KeypointKind::Orb, truth, counts.tolerance);
    counts.sift = countKeypoints(a, b, bench::KeypointKind::Sift, truth, counts.tolerance);
  });
  return result;
}

}  // namespace sbox::paper
