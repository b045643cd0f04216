// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/place_maps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace sbox {
namespace {

/// Sets of maps that grow together (union-find; the lowest member stands for its set).
class Sets {
 public:
  explicit Sets(int count) : parent_(static_cast<size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int map) const {
    while (parent_[static_cast<size_t>(map)] != map) {
      map = parent_[static_cast<size_t>(map)];
    }
    return map;
  }
  /// False when both were in one set already.
  bool join(int a, int b) {
    const int low = std::min(find(a), find(b)), high = std::max(find(a), find(b));
    parent_[static_cast<size_t>(high)] = low;
    return low != high;
  }

 private:
  std::vector<int> parent_;
};

/// A tree edge seen from one of its maps.
struct Step {
  int to = 0;
  Pose2D pose_to_in_from;
  PoseCovariance covariance;
};

/// Covariance of pose_c_in_a = pose_b_in_a + pose_c_in_b for independent errors, to first order.
PoseCovariance composedCovariance(const Pose2D& pose_b_in_a, const PoseCovariance& b_in_a,
                                  const Pose2D& pose_c_in_b, const PoseCovariance& c_in_b) {
  const double c = std::cos(pose_b_in_a.phi), s = std::sin(pose_b_in_a.phi);
  const double x = pose_c_in_b.x, y = pose_c_in_b.y;
  Eigen::Matrix3d by_b = Eigen::Matrix3d::Identity();
  by_b(0, 2) = -s * x - c * y;
  by_b(1, 2) = c * x - s * y;
  Eigen::Matrix3d by_c;
  by_c << c, -s, 0, s, c, 0, 0, 0, 1;
  return by_b * b_in_a * by_b.transpose() + by_c * c_in_b * by_c.transpose();
}

std::vector<const MapPair*> usablePairs(int map_count, const std::vector<MapPair>& pairs,
                                        const PlacementOptions& options) {
  std::vector<const MapPair*> usable;
  for (const MapPair& pair : pairs) {
    if (pair.a < 0 || pair.b < 0 || pair.a >= map_count || pair.b >= map_count) {
      throw std::invalid_argument("a pair names a map that does not exist");
    }
    if (pair.result.verdict == Verdict::Accepted &&
        pair.result.confidence >= options.min_confidence) {
      usable.push_back(&pair);
    }
  }
  std::sort(usable.begin(), usable.end(), [](const MapPair* left, const MapPair* right) {
    return std::make_tuple(-left->result.confidence, left->a, left->b) <
           std::make_tuple(-right->result.confidence, right->a, right->b);
  });
  return usable;
}

/// Poses along the tree, from the reference outwards.
void placeGroup(const std::vector<std::vector<Step>>& tree, int reference,
                std::vector<MapPlacement>& maps) {
  std::vector<std::pair<int, int>> open{{reference, -1}};
  while (!open.empty()) {
    const auto [map, came_from] = open.back();
    open.pop_back();
    const MapPlacement& here = maps[static_cast<size_t>(map)];
    for (const Step& step : tree[static_cast<size_t>(map)]) {
      if (step.to == came_from) {
        continue;
      }
      MapPlacement& there = maps[static_cast<size_t>(step.to)];
      there.pose = here.pose + step.pose_to_in_from;
      there.pose.phi = wrapAngle(there.pose.phi);
      there.covariance =
          composedCovariance(here.pose, here.covariance, step.pose_to_in_from, step.covariance);
      open.emplace_back(step.to, map);
    }
  }
}

}  // namespace

PlacementResult placeMaps(int map_count, const std::vector<MapPair>& pairs,
                          std::optional<int> reference, const PlacementOptions& options) {
  if (map_count < 1 || (reference && (*reference < 0 || *reference >= map_count))) {
    throw std::invalid_argument("placement needs maps, and a reference among them");
  }
  Sets sets(map_count);
  std::vector<std::vector<Step>> tree(static_cast<size_t>(map_count));
  for (const MapPair* pair : usablePairs(map_count, pairs, options)) {
    if (!sets.join(pair->a, pair->b)) {
      continue;
    }
    const PairResult& edge = pair->result;
    tree[static_cast<size_t>(pair->a)].push_back({pair->b, edge.pose_b_in_a, edge.covariance});
    tree[static_cast<size_t>(pair->b)].push_back(
        {pair->a, inverse(edge.pose_b_in_a), inverseCovariance(edge.pose_b_in_a, edge.covariance)});
  }

  PlacementResult result;
  result.maps.resize(static_cast<size_t>(map_count));
  for (int map = 0; map < map_count; ++map) {
    const int first = sets.find(map);
    if (first == map) {
      result.maps[static_cast<size_t>(map)].group = static_cast<int>(result.groups.size());
      result.groups.push_back({map, {}});
    }
    const int number = result.maps[static_cast<size_t>(first)].group;
    result.maps[static_cast<size_t>(map)].group = number;
    MapGroup& group = result.groups[static_cast<size_t>(number)];
    group.members.push_back(map);
    if (reference == map) {
      group.reference = map;
    }
  }
  for (const MapGroup& group : result.groups) {
    placeGroup(tree, group.reference, result.maps);
  }
  const auto largest = std::max_element(result.groups.begin(), result.groups.end(),
                                        [](const MapGroup& left, const MapGroup& right) {
                                          return left.members.size() < right.members.size();
                                        });
  result.largest = static_cast<int>(largest - result.groups.begin());
  return result;
}

}  // namespace sbox
