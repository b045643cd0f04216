// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/pose_graph.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "sbox/core/cholesky.h"
#include "sbox/core/pose_errors.h"

namespace sbox {
namespace {

using Node = std::array<double, 3>;

/// Where an edge says that node b lies against where it does: the logarithm of the transform from
/// one to the other, in standard deviations. Unlike a difference of coordinates it is the same for
/// the inverse edge, so that the order of the maps does not matter.
struct EdgeCost {
  Pose2D pose_b_in_a;
  Eigen::Matrix3d root;  ///< L of the covariance L L^T along the axes of b.

  template <typename T>
  bool operator()(const T* a, const T* b, T* residuals) const {
    using std::abs;
    using std::cos;
    using std::floor;
    using std::sin;
    T turn = b[2] - a[2] - pose_b_in_a.phi;
    turn -= 2 * M_PI * floor(turn / (2 * M_PI) + 0.5);
    // From the edge's b to the node, along the axes of the edge's b.
    const T heading = a[2] + pose_b_in_a.phi;
    const T c = cos(heading), s = sin(heading);
    const T dx = b[0] - a[0], dy = b[1] - a[1];
    const double ce = std::cos(pose_b_in_a.phi), se = std::sin(pose_b_in_a.phi);
    const T x = c * dx + s * dy - (ce * pose_b_in_a.x + se * pose_b_in_a.y);
    const T y = -s * dx + c * dy - (ce * pose_b_in_a.y - se * pose_b_in_a.x);
    const T half = turn / 2.0;
    const T along = abs(half) < 1e-4 ? 1.0 - half * half / 3.0 : half * cos(half) / sin(half);
    // root^-1 (along x + half y, along y - half x, turn), by forward substitution.
    residuals[0] = (along * x + half * y) / root(0, 0);
    residuals[1] = (along * y - half * x - root(1, 0) * residuals[0]) / root(1, 1);
    residuals[2] = (turn - root(2, 0) * residuals[0] - root(2, 1) * residuals[1]) / root(2, 2);
    return true;
  }
};

EdgeCost costOf(const GraphEdge& edge) {
  const Eigen::Matrix3d turn = turnedAxes(-edge.pose_b_in_a.phi);
  const Eigen::Matrix3d along_b = turn * edge.covariance * turn.transpose();
  return {edge.pose_b_in_a, choleskyFactor(along_b)};
}

Node nodeOf(const Pose2D& pose) { return {pose.x, pose.y, pose.phi}; }

/// Derivative of an edge's (x, y, phi) by those of its nodes, whitened.
void edgeJacobians(const GraphEdge& edge, const std::vector<Pose2D>& poses, Eigen::Matrix3d& by_a,
                   Eigen::Matrix3d& by_b) {
  const ceres::AutoDiffCostFunction<EdgeCost, 3, 3, 3> cost(new EdgeCost(costOf(edge)));
  const Node a = nodeOf(poses[static_cast<size_t>(edge.a)]);
  const Node b = nodeOf(poses[static_cast<size_t>(edge.b)]);
  const std::array<const double*, 2> nodes{a.data(), b.data()};
  Eigen::Vector3d residual;
  using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Rows rows_a = Rows::Zero(), rows_b = Rows::Zero();
  std::array<double*, 2> jacobians{rows_a.data(), rows_b.data()};
  cost.Evaluate(nodes.data(), residual.data(), jacobians.data());
  by_a = rows_a;
  by_b = rows_b;
}

/// How much of an edge's information is left by Cauchy's loss.
double cauchyWeight(double squared_residual, double scale) {
  return 1 / (1 + squared_residual / (scale * scale));
}

}  // namespace

double squaredResidual(const GraphEdge& edge, const Pose2D& pose_a, const Pose2D& pose_b) {
  const Node a = nodeOf(pose_a), b = nodeOf(pose_b);
  Eigen::Vector3d residual;
  costOf(edge)(a.data(), b.data(), residual.data());
  return residual.squaredNorm();
}

PoseGraphSolution solvePoseGraph(const std::vector<Pose2D>& start, int reference,
                                 const std::vector<GraphEdge>& edges,
                                 const PoseGraphOptions& options) {
  PoseGraphSolution solution;
  solution.poses = start;
  if (!edges.empty()) {
    std::vector<Node> nodes(start.size());
    std::transform(start.begin(), start.end(), nodes.begin(), nodeOf);
    ceres::CauchyLoss loss(options.loss_scale);
    ceres::Problem::Options problem_options;
    problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(problem_options);
    Node& fixed = nodes[static_cast<size_t>(reference)];
    problem.AddParameterBlock(fixed.data(), 3);
    problem.SetParameterBlockConstant(fixed.data());
    for (const GraphEdge& edge : edges) {
      problem.AddResidualBlock(
          new ceres::AutoDiffCostFunction<EdgeCost, 3, 3, 3>(new EdgeCost(costOf(edge))), &loss,
          nodes[static_cast<size_t>(edge.a)].data(), nodes[static_cast<size_t>(edge.b)].data());
    }
    ceres::Solver::Options solver;
    // For thousands of nodes. Eigen's, which adds in the same order whatever the machine.
    constexpr size_t most_dense = 50;
    solver.linear_solver_type =
        nodes.size() <= most_dense ? ceres::DENSE_NORMAL_CHOLESKY : ceres::SPARSE_NORMAL_CHOLESKY;
    solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    solver.max_num_iterations = options.iterations;
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    solver.function_tolerance = 1e-12;
    solver.parameter_tolerance = 1e-12;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    for (size_t i = 0; i < nodes.size(); ++i) {
      solution.poses[i] = {nodes[i][0], nodes[i][1], wrapAngle(nodes[i][2])};
    }
  }
  double squares = 0;
  for (const GraphEdge& edge : edges) {
    const double squared = squaredResidual(edge, solution.poses[static_cast<size_t>(edge.a)],
                                           solution.poses[static_cast<size_t>(edge.b)]);
    const double weight = cauchyWeight(squared, options.loss_scale);
    solution.edge_weights.push_back(weight);
    squares += weight * squared;
  }
  const auto spare =
      3 * (static_cast<double>(edges.size()) - static_cast<double>(start.size()) + 1);
  solution.variance_factor = spare > 0 ? std::max(1.0, squares / spare) : 1.0;
  return solution;
}

std::vector<PoseCovariance> poseCovariances(const PoseGraphSolution& solution, int reference,
                                            const std::vector<GraphEdge>& edges) {
  const auto count = static_cast<int>(solution.poses.size());
  std::vector<PoseCovariance> covariances(static_cast<size_t>(count), PoseCovariance::Zero());
  if (count < 2) {
    return covariances;
  }
  // The reference has no rows.
  const auto rowOf = [&](int node) { return 3 * (node < reference ? node : node - 1); };
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(3 * (count - 1), 3 * (count - 1));
  for (size_t i = 0; i < edges.size(); ++i) {
    const std::array<int, 2> nodes{edges[i].a, edges[i].b};
    std::array<Eigen::Matrix3d, 2> jacobians;
    edgeJacobians(edges[i], solution.poses, jacobians[0], jacobians[1]);
    for (size_t row = 0; row < 2; ++row) {
      for (size_t column = 0; column < 2; ++column) {
        if (nodes[row] != reference && nodes[column] != reference) {
          information.block<3, 3>(rowOf(nodes[row]), rowOf(nodes[column])) +=
              solution.edge_weights[i] * jacobians[row].transpose() * jacobians[column];
        }
      }
    }
  }
  const Eigen::MatrixXd inverse_information = solvePositiveDefinite(
      information, Eigen::MatrixXd::Identity(information.rows(), information.cols()));
  for (int node = 0; node < count; ++node) {
    if (node != reference) {
      const PoseCovariance block =
          solution.variance_factor * inverse_information.block<3, 3>(rowOf(node), rowOf(node));
      covariances[static_cast<size_t>(node)] = (block + block.transpose()) / 2;
    }
  }
  return covariances;
}

std::vector<std::vector<size_t>> connectedParts(size_t pose_count,
                                                const std::vector<GraphEdge>& edges) {
  std::vector<size_t> root(pose_count);
  std::iota(root.begin(), root.end(), size_t{0});
  const auto rootOf = [&](size_t pose) {
    while (root[pose] != pose) {
      pose = root[pose] = root[root[pose]];
    }
    return pose;
  };
  for (const GraphEdge& edge : edges) {
    const size_t a = rootOf(static_cast<size_t>(edge.a)), b = rootOf(static_cast<size_t>(edge.b));
    root[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::vector<size_t>> of_root(pose_count), parts;
  for (size_t pose = 0; pose < pose_count; ++pose) {
    of_root[rootOf(pose)].push_back(pose);
  }
  for (std::vector<size_t>& part : of_root) {
    if (!part.empty()) {
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

}  // namespace sbox
