// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The poses of a group that fit all its edges best: least squares under a robust loss, by Ceres.
#pragma once

#include <vector>

#include "sbox/core/pose.h"

namespace sbox {

/// A transform between two nodes of the graph.
struct GraphEdge {
  int a = 0;                  ///< Node.
  int b = 0;                  ///< Node.
  Pose2D pose_b_in_a;         ///< Frame of b in the frame of a.
  PoseCovariance covariance;  ///< Positive definite.
};

/// Squared distance between an edge and the poses of its nodes, in standard deviations; the same
/// for the inverse edge between the exchanged nodes.
[[nodiscard]] double squaredResidual(const GraphEdge& edge, const Pose2D& pose_a,
                                     const Pose2D& pose_b);

/// Options of the solution.
struct PoseGraphOptions {
  double loss_scale = 2;  ///< Of Cauchy's loss, in standard deviations of an edge.
  int iterations = 50;    ///< At most, for each of four losses that narrow to this scale.
};

/// What fits best.
struct PoseGraphSolution {
  std::vector<Pose2D> poses;         ///< Of the nodes; that of the reference is as it was given.
  std::vector<double> edge_weights;  ///< What the loss leaves of each edge's information; (0, 1].
  /// By which the squared residuals exceed what the covariances promise; 1 or more.
  double variance_factor = 1;
};

/// Moves the poses of all nodes but the reference, from `start`, to where the edges fit best.
[[nodiscard]] PoseGraphSolution solvePoseGraph(const std::vector<Pose2D>& start, int reference,
                                               const std::vector<GraphEdge>& edges,
                                               const PoseGraphOptions& options = {});

/// Covariance of each node's pose in the frame of the reference, for a solved graph that is
/// connected; zero for the reference. Where edges disagree more than their covariances allow, it
/// grows by the variance factor.
[[nodiscard]] std::vector<PoseCovariance> poseCovariances(const PoseGraphSolution& solution,
                                                          int reference,
                                                          const std::vector<GraphEdge>& edges);

/// The poses, by index, that edges tie together, each part in ascending order; the parts by their
/// first.
[[nodiscard]] std::vector<std::vector<size_t>> connectedParts(size_t pose_count,
                                                              const std::vector<GraphEdge>& edges);

}  // namespace sbox
