// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/adjustment/adjust_key_frames.h"

#include <mrpt/poses/CPose3D.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "sbox/core/parallel.h"
#include "sbox/placement/pose_graph.h"

namespace sbox {
namespace {

Pose2D poseOf(const KeyFrame& key_frame) {
  return Pose2D(key_frame.robot_in_map->getMeanVal().asTPose());
}

/// What does not change from round to round.
struct Scene {
  std::vector<std::vector<ScanPoint>> points;  ///< Of each key frame.
  std::vector<int> map_of;                     ///< Number of the map of each key frame.
  std::vector<GraphEdge> steps;                ///< From one key frame of a map to the next.
};

PoseCovariance stepCovariance(const Pose2D& step, const AdjustmentOptions& options) {
  const double metres = options.step_metres + options.step_share * std::hypot(step.x, step.y);
  return Eigen::Vector3d(metres * metres, metres * metres, options.step_turn * options.step_turn)
      .asDiagonal();
}

Scene makeScene(const KeyFrames& frames, const std::vector<int>& map_of,
                const std::vector<Pose2D>& poses, const AdjustmentOptions& options, int threads) {
  Scene scene;
  scene.map_of = map_of;
  scene.points.resize(frames.size());
  parallelFor(static_cast<int>(frames.size()), threads, [&](int i) {
    const auto index = static_cast<size_t>(i);
    scene.points[index] = scanPoints(*frames[index].seen, options.points);
  });
  for (size_t i = 1; i < frames.size(); ++i) {
    if (map_of[i - 1] == map_of[i]) {
      const Pose2D step = inverse(poses[i - 1]) + poses[i];
      scene.steps.push_back(
          {static_cast<int>(i) - 1, static_cast<int>(i), step, stepCovariance(step, options)});
    }
  }
  return scene;
}

/// The edges of the drives and of what was seen from two places.
std::vector<GraphEdge> edgesAt(const std::vector<Pose2D>& poses, const Scene& scene,
                               const AdjustmentOptions& options, int threads) {
  std::vector<FramePair> pairs = overlappingFrames(poses, scene.map_of, options.overlap);
  for (const GraphEdge& step : scene.steps) {
    pairs.push_back({step.a, step.b});
  }
  std::vector<std::optional<ScanMatch>> matches(pairs.size());
  parallelFor(static_cast<int>(pairs.size()), threads, [&](int i) {
    const auto index = static_cast<size_t>(i);
    const auto a = static_cast<size_t>(pairs[index].a), b = static_cast<size_t>(pairs[index].b);
    matches[index] =
        matchScans(scene.points[a], scene.points[b], inverse(poses[a]) + poses[b], options.match);
  });
  std::vector<GraphEdge> edges = scene.steps;
  for (size_t i = 0; i < pairs.size(); ++i) {
    if (matches[i]) {
      edges.push_back({pairs[i].a, pairs[i].b, matches[i]->pose_b_in_a, matches[i]->covariance});
    }
  }
  return edges;
}

/// Moves the poses of a part so that its anchors lie, on average, where they lay before.
void putBack(std::vector<Pose2D>& poses, const std::vector<Pose2D>& before,
             const std::vector<size_t>& part, const std::vector<size_t>& anchors) {
  const auto place = [](const Pose2D& pose) { return Eigen::Vector2d(pose.x, pose.y); };
  const auto count = static_cast<double>(anchors.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero(), mean_before = Eigen::Vector2d::Zero();
  for (const size_t i : anchors) {
    mean += place(poses[i]) / count;
    mean_before += place(before[i]) / count;
  }
  // A radian of heading counts as a metre: a robot that stood still has no other.
  double sine = 0, cosine = 0;
  for (const size_t i : anchors) {
    const Eigen::Vector2d from = place(poses[i]) - mean, to = place(before[i]) - mean_before;
    const double turn = before[i].phi - poses[i].phi;
    sine += from.x() * to.y() - from.y() * to.x() + std::sin(turn);
    cosine += from.dot(to) + std::cos(turn);
  }
  const double turn = std::atan2(sine, cosine);
  const Eigen::Vector2d shift = mean_before - Eigen::Rotation2Dd(turn) * mean;
  const Pose2D correction(shift.x(), shift.y(), turn);
  for (const size_t i : part) {
    poses[i] = correction + poses[i];
  }
}

}  // namespace

KeyFrames adjustKeyFrames(const std::vector<PlacedKeyFrames>& maps, size_t reference,
                          const AdjustmentOptions& options, int threads,
                          const ProgressFunction& progress) {
  if (reference >= maps.size()) {
    throw std::invalid_argument("the reference is none of the maps");
  }
  KeyFrames frames = joinKeyFrames(maps);
  std::vector<int> map_of;
  std::vector<size_t> firsts;
  for (size_t i = 0; i < maps.size(); ++i) {
    firsts.push_back(map_of.size());
    map_of.insert(map_of.end(), maps[i].key_frames->size(), static_cast<int>(i));
  }
  firsts.push_back(map_of.size());
  const size_t first = firsts[reference], end = firsts[reference + 1];
  if (first == end) {
    return frames;
  }
  std::vector<Pose2D> before;
  for (const KeyFrame& frame : frames) {
    before.push_back(poseOf(frame));
  }
  const Scene scene = makeScene(frames, map_of, before, options, threads);
  std::vector<Pose2D> poses = before;
  PoseGraphOptions graph;
  graph.loss_scale = options.loss_scale;
  StageProgress rounds(progress, "adjustment", options.rounds);
  std::vector<GraphEdge> edges;
  for (int round = 0; round < options.rounds; ++round) {
    edges = edgesAt(poses, scene, options, threads);
    poses = solvePoseGraph(poses, static_cast<int>(first), edges, graph).poses;
    rounds.partDone();
  }
  // What nothing ties to the reference stays where it was placed.
  for (const std::vector<size_t>& part : connectedParts(poses.size(), edges)) {
    std::vector<size_t> anchors;
    std::copy_if(part.begin(), part.end(), std::back_inserter(anchors),
                 [&](size_t i) { return i >= first && i < end; });
    putBack(poses, before, part, anchors.empty() ? part : anchors);
  }
  KeyFrames adjusted;
  for (size_t i = 0; i < frames.size(); ++i) {
    const Pose2D correction = poses[i] + inverse(before[i]);
    adjusted.push_back(
        moveKeyFrames({frames[i]}, mrpt::poses::CPose3D(mrpt::math::TPose3D(correction))).front());
  }
  return adjusted;
}

}  // namespace sbox
