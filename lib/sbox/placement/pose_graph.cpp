// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/pose_graph.h"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "sbox/core/cholesky.h"
#include "sbox/placement/edge_residual.h"

namespace sbox {
namespace {

using Node = Eigen::Vector3d;  // x, y, phi.
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Node nodeOf(const Pose2D& pose) { return {pose.x, pose.y, pose.phi}; }

/// The residual of an edge, for Ceres.
class EdgeCost final : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  explicit EdgeCost(const GraphEdge& edge) : residual_(edge.pose_b_in_a, edge.covariance) {}
  bool Evaluate(const double* const* nodes, double* residual, double** by_nodes) const override {
    const Node a(nodes[0]), b(nodes[1]);
    Eigen::Map<Eigen::Vector3d>{residual} = residual_.at(a, b);
    if (by_nodes != nullptr) {
      const EdgeJacobians jacobians = residual_.jacobiansAt(a, b);
      if (by_nodes[0] != nullptr) {
        Eigen::Map<RowMajor>{by_nodes[0]} = jacobians.by_a;
      }
      if (by_nodes[1] != nullptr) {
        Eigen::Map<RowMajor>{by_nodes[1]} = jacobians.by_b;
      }
    }
    return true;
  }

 private:
  EdgeResidual residual_;
};

/// How much of an edge's information is left by Cauchy's loss.
double cauchyWeight(double squared_residual, double scale) {
  return 1 / (1 + squared_residual / (scale * scale));
}

}  // namespace

double squaredResidual(const GraphEdge& edge, const Pose2D& pose_a, const Pose2D& pose_b) {
  return EdgeResidual(edge.pose_b_in_a, edge.covariance)
      .at(nodeOf(pose_a), nodeOf(pose_b))
      .squaredNorm();
}

PoseGraphSolution solvePoseGraph(const std::vector<Pose2D>& start, int reference,
                                 const std::vector<GraphEdge>& edges,
                                 const PoseGraphOptions& options) {
  PoseGraphSolution solution;
  solution.poses = start;
  if (!edges.empty()) {
    std::vector<Node> nodes(start.size());
    std::transform(start.begin(), start.end(), nodes.begin(), nodeOf);
    ceres::LossFunctionWrapper loss(nullptr, ceres::TAKE_OWNERSHIP);
    ceres::Problem::Options problem_options;
    problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(problem_options);
    Node& fixed = nodes[static_cast<size_t>(reference)];
    problem.AddParameterBlock(fixed.data(), 3);
    problem.SetParameterBlockConstant(fixed.data());
    for (const GraphEdge& edge : edges) {
      problem.AddResidualBlock(new EdgeCost(edge), &loss, nodes[static_cast<size_t>(edge.a)].data(),
                               nodes[static_cast<size_t>(edge.b)].data());
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
    // A narrow loss has several minima; by way of wider ones that which is reached hardly depends
    // on the start.
    for (const double widening : {64, 16, 4, 1}) {
      loss.Reset(new ceres::CauchyLoss(widening * options.loss_scale), ceres::TAKE_OWNERSHIP);
      ceres::Solve(solver, &problem, &summary);
    }
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
    const GraphEdge& edge = edges[i];
    const std::array<int, 2> nodes{edge.a, edge.b};
    const auto [by_a, by_b] = EdgeResidual(edge.pose_b_in_a, edge.covariance)
                                  .jacobiansAt(nodeOf(solution.poses[static_cast<size_t>(edge.a)]),
                                               nodeOf(solution.poses[static_cast<size_t>(edge.b)]));
    const std::array<Eigen::Matrix3d, 2> jacobians{by_a, by_b};
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
