// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "catch.h"
#include "sbox/placement/place_maps.h"
#include "sbox/report/graph_text.h"

using namespace sbox;

namespace {

struct Edge {
  int a, b;
  Pose2D pose_b_in_a;
  Eigen::Matrix3d information;
};

struct Graph {
  std::map<int, Pose2D> vertices;
  std::vector<Edge> edges;
  int fixed = -1;
};

Graph read(const std::string& text) {
  Graph graph;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "VERTEX2") {
      int map = 0;
      Pose2D pose;
      words >> map >> pose.x >> pose.y >> pose.phi;
      graph.vertices[map] = pose;
    } else if (key == "FIX") {
      words >> graph.fixed;
    } else if (key == "EDGE2") {
      Edge edge{};
      words >> edge.a >> edge.b >> edge.pose_b_in_a.x >> edge.pose_b_in_a.y >> edge.pose_b_in_a.phi;
      for (int row = 0; row < 3; ++row) {
        for (int column = row; column < 3; ++column) {
          words >> edge.information(row, column);
          edge.information(column, row) = edge.information(row, column);
        }
      }
      graph.edges.push_back(edge);
    }
    CHECK_FALSE(words.fail());
  }
  return graph;
}

/// What MRPT's optimiser makes least: squared differences along the axes of b, by information.
double costOf(const Graph& graph) {
  double cost = 0;
  for (const Edge& edge : graph.edges) {
    const Pose2D difference = inverse(edge.pose_b_in_a) +
                              (inverse(graph.vertices.at(edge.a)) + graph.vertices.at(edge.b));
    const Eigen::Vector3d error(difference.x, difference.y, wrapAngle(difference.phi));
    cost += error.dot(edge.information * error);
  }
  return cost;
}

/// Four maps and five pairs that nearly agree; a sixth is wrong.
MergeResult placedMaps() {
  const std::vector<Pose2D> truth{{0, 0, 0}, {4, 1, 0.7}, {-3, 5, -2.1}, {8, -2, 3.1}};
  MergeResult result;
  for (int a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b) {
      const double drift = 0.05 * (b - 2.4 * a);
      MapPair pair{a, b, {}};
      pair.result.verdict = Verdict::Accepted;
      pair.result.has_pose = true;
      pair.result.pose_b_in_a = inverse(truth[static_cast<size_t>(a)]) +
                                truth[static_cast<size_t>(b)] + Pose2D(drift, -drift, 0.05 * drift);
      pair.result.covariance = Eigen::Vector3d(0.01, 0.04, 0.001).asDiagonal();
      pair.result.confidence = 0.999;
      result.pairs.push_back(pair);
    }
  }
  result.pairs[1].result.alternatives = {{result.pairs[1].result.pose_b_in_a, 0.3}};
  result.pairs[1].result.pose_b_in_a.x += 30;
  result.pairs[1].result.confidence = 0.4;
  result.pairs[1].result.verdict = Verdict::Ambiguous;
  result.pairs[2].result.pose_b_in_a.x += 40;
  result.pairs[2].result.confidence = 0.8;
  const PlacementResult placed = placeMaps(std::vector<Footprint>(4), result.pairs, 1);
  for (size_t i = 0; i < 4; ++i) {
    MapOutcome map;
    map.name = "map\n" + std::to_string(i);
    map.placement = placed.maps[i];
    result.maps.push_back(map);
  }
  for (size_t i = 0; i < result.pairs.size(); ++i) {
    result.pairs[i].settlement = placed.settlements[i];
  }
  MergedGroup group;
  group.reference = 1;
  group.members = {0, 1, 2, 3};
  result.merged.push_back(group);
  return result;
}

}  // namespace

TEST_CASE("a graph has the poses of its maps and the pairs that agree") {
  const MergeResult result = placedMaps();
  const std::string text = graphText(result, result.merged[0]);
  const Graph graph = read(text);
  CHECK(graph.fixed == 1);
  REQUIRE(graph.vertices.size() == 4);
  for (int map = 0; map < 4; ++map) {
    CHECK(graph.vertices.at(map).x == result.maps[static_cast<size_t>(map)].placement.pose.x);
    CHECK(graph.vertices.at(map).phi == result.maps[static_cast<size_t>(map)].placement.pose.phi);
  }
  REQUIRE(graph.edges.size() == 5);
  // The alternative that agrees, not the candidate that was thought likelier.
  CHECK(graph.edges[1].b == 2);
  CHECK(graph.edges[1].pose_b_in_a.x == result.pairs[1].result.alternatives[0].pose_b_in_a.x);
  CHECK(text.find("# 2: map?2\n") != std::string::npos);
  CHECK(text.find("# pair 0 3 does not agree: off by ") != std::string::npos);
}

TEST_CASE("the poses of a graph are those that its edges want") {
  const MergeResult result = placedMaps();
  Graph graph = read(graphText(result, result.merged[0]));
  const double least = costOf(graph);
  CHECK(least > 0.01);
  for (const int map : {0, 2, 3}) {
    for (size_t axis = 0; axis < 3; ++axis) {
      for (const double step : {-1e-3, 1e-3}) {
        graph.vertices[map][axis] += step;
        CHECK(costOf(graph) > least);
        graph.vertices[map][axis] -= step;
      }
    }
  }
}
