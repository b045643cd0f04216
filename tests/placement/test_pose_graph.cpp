// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/placement/pose_graph.h"

using namespace sbox;

namespace {

PoseCovariance spread(double metres, double radians) {
  return Eigen::Vector3d(metres * metres, metres * metres, radians * radians).asDiagonal();
}

/// Sum of Cauchy's loss over the edges, written anew.
double costOf(const std::vector<GraphEdge>& edges, const std::vector<Pose2D>& poses, double scale) {
  double cost = 0;
  for (const GraphEdge& edge : edges) {
    const double squared = squaredResidual(edge, poses[static_cast<size_t>(edge.a)],
                                           poses[static_cast<size_t>(edge.b)]);
    cost += scale * scale * std::log1p(squared / (scale * scale));
  }
  return cost;
}

}  // namespace

TEST_CASE("the residual of an edge is that of its inverse") {
  const Pose2D a(1, -2, 0.3), b(-4, 5, 2.5), measured(3, 1, -2);
  PoseCovariance covariance = spread(0.3, 0.05);
  covariance(0, 1) = covariance(1, 0) = 0.02;
  covariance(1, 2) = covariance(2, 1) = 0.005;
  const double there = squaredResidual({0, 1, measured, covariance}, a, b);
  const double back =
      squaredResidual({1, 0, inverse(measured), inverseCovariance(measured, covariance)}, b, a);
  CHECK(there == Approx(back));
  CHECK(there > 1);
}

TEST_CASE("near its pose the residual of an edge is the distance by its covariance") {
  PoseCovariance covariance = spread(0.3, 0.05);
  covariance(0, 2) = covariance(2, 0) = 0.01;
  const Pose2D measured(3, 1, -2);
  const Eigen::Vector3d offset(1e-4, -2e-4, 1e-5);
  const Pose2D moved(3 + offset.x(), 1 + offset.y(), -2 + offset.z());
  CHECK(squaredResidual({0, 1, measured, covariance}, {}, moved) ==
        Approx(offset.dot(covariance.llt().solve(offset))).epsilon(1e-3));
}

TEST_CASE("two edges meet at their mean, by their information") {
  const std::vector<GraphEdge> edges{{0, 1, {1, 0, 0}, spread(0.1, 0.1)},
                                     {0, 1, {1.03, 0, 0}, spread(0.2, 0.1)}};
  PoseGraphOptions options;
  options.loss_scale = 1000;
  const PoseGraphSolution solution = solvePoseGraph({{}, {1, 0, 0}}, 0, edges, options);
  CHECK(solution.poses[1].x == Approx(1.006).epsilon(1e-6));
  const std::vector<PoseCovariance> covariances = poseCovariances(solution, 0, edges);
  CHECK(covariances[0].norm() == 0);
  CHECK(covariances[1](0, 0) == Approx(1 / (100.0 + 25)).epsilon(1e-3));
  CHECK(covariances[1](2, 2) == Approx(0.005).epsilon(1e-3));
}

TEST_CASE("edges that contradict their covariances make poses less sure") {
  const std::vector<GraphEdge> edges{{0, 1, {1, 0, 0}, spread(0.1, 0.1)},
                                     {0, 1, {2, 0, 0}, spread(0.1, 0.1)}};
  PoseGraphOptions options;
  options.loss_scale = 1000;
  const PoseGraphSolution solution = solvePoseGraph({{}, {1, 0, 0}}, 0, edges, options);
  // Each is off by 5 standard deviations; there are 3 numbers to spare.
  CHECK(solution.variance_factor == Approx(50 / 3.0).epsilon(1e-3));
  CHECK(poseCovariances(solution, 0, edges)[1](0, 0) == Approx(0.005 * 50 / 3).epsilon(1e-3));
}

TEST_CASE("the solution of a random graph cannot be bettered by moving a node") {
  std::mt19937 random(7);  // NOLINT: the same every time
  const auto draw = [&](double scale) {
    return scale * (static_cast<double>(random() % 2001) / 1000 - 1);
  };
  std::vector<Pose2D> start;
  for (int i = 0; i < 5; ++i) {
    start.emplace_back(draw(10), draw(10), draw(3));
  }
  std::vector<GraphEdge> edges;
  for (int a = 0; a < 5; ++a) {
    for (int b = a + 1; b < 5; ++b) {
      const Pose2D measured = inverse(start[static_cast<size_t>(a)]) +
                              start[static_cast<size_t>(b)] +
                              Pose2D(draw(0.5), draw(0.5), draw(0.1));
      edges.push_back({a, b, measured, spread(0.2, 0.05)});
    }
  }
  edges[4].pose_b_in_a.x += 6;
  const PoseGraphOptions options;
  const PoseGraphSolution solution = solvePoseGraph(start, 2, edges, options);
  CHECK(solution.poses[2].x == start[2].x);
  const double least = costOf(edges, solution.poses, options.loss_scale);
  CHECK(least < costOf(edges, start, options.loss_scale));
  for (const size_t node : {0, 1, 3, 4}) {
    for (size_t axis = 0; axis < 3; ++axis) {
      for (const double step : {-1e-3, 1e-3}) {
        std::vector<Pose2D> moved = solution.poses;
        moved[node][axis] += step;
        CHECK(costOf(edges, moved, options.loss_scale) > least);
      }
    }
  }
  // The outlier has lost its weight.
  CHECK(solution.edge_weights[4] < 0.05);
}

TEST_CASE("a graph of more nodes than a dense matrix is used for comes out right") {
  constexpr int count = 80;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> off(-0.1, 0.1);
  std::vector<Pose2D> truth, start;
  std::vector<GraphEdge> edges;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * M_PI * i / count;
    truth.emplace_back(10 * std::cos(turn), 10 * std::sin(turn), wrapAngle(turn));
    start.push_back(truth.back() + (i == 3 ? Pose2D() : Pose2D(off(random), off(random), 0.05)));
  }
  for (int a = 0; a < count; ++a) {
    for (const int step : {1, 7}) {
      const int b = (a + step) % count;
      const Pose2D b_in_a = inverse(truth[static_cast<size_t>(a)]) + truth[static_cast<size_t>(b)];
      edges.push_back({a, b, b_in_a, spread(0.1, 0.02)});
    }
  }
  edges.push_back({0, 40, {}, spread(0.1, 0.02)});  // wrong
  const PoseGraphSolution solution = solvePoseGraph(start, 3, edges);
  for (size_t i = 0; i < truth.size(); ++i) {
    CHECK(std::hypot(solution.poses[i].x - truth[i].x, solution.poses[i].y - truth[i].y) < 0.02);
  }
  CHECK(solution.edge_weights.back() < 0.01);
}

TEST_CASE("edges that disagree are settled alike from any start") {
  // Two say here and one says there, each so sure that the loss has a minimum at either.
  const std::vector<GraphEdge> edges{{0, 1, {0, 0, 0}, spread(0.05, 0.01)},
                                     {0, 1, {0.1, 0, 0}, spread(0.05, 0.01)},
                                     {0, 1, {2, 0, 0.05}, spread(0.05, 0.01)}};
  for (const double start : {-1.0, 0.0, 1.0, 2.0, 3.0}) {
    INFO("from " << start);
    CHECK(solvePoseGraph({{}, {start, 0, 0.02}}, 0, edges).poses[1].x == Approx(0.06).margin(0.03));
  }
}
