// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/bending/bend_maps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sbox/bending/bend_map.h"
#include "sbox/core/parallel.h"
#include "sbox/features/grid_pose.h"

namespace sbox {
namespace {

RigidTransform placedOn(const MapFeatures& ground, const MapFeatures& map, const Pose2D& placed) {
  const Pose2D pose = gridPose(ground, Pose2D(), map, placed);
  return {pose.phi, {pose.x, pose.y}};
}

double largestShift(const DriftField& drift) {
  double largest = 0;
  for (const Eigen::Vector2d& displacement : drift.displacements) {
    largest = std::max(largest, displacement.norm());
  }
  return largest;
}

double meanShift(const DriftField& drift, const MapFeatures& map, const RigidTransform& transform) {
  double sum = 0;
  for (const WallPoint& point : map.wall_points) {
    sum += drift.at(transform * point.position).squaredNorm();
  }
  return std::sqrt(sum / std::max<double>(1, static_cast<double>(map.wall_points.size())));
}

/// The maps that have been laid down so far, as one.
class Ground {
 public:
  Ground(const BendOptions& options, const Map& reference) : options_(options) {
    laid_.push_back({&reference, Pose2D()});
    update();
  }

  void add(const Map& map) {
    laid_.push_back({&map, Pose2D()});
    update();
  }

  [[nodiscard]] const MapFeatures& features() const { return features_; }

 private:
  void update() {
    features_ = extractFeatures(
        laid_.size() == 1 ? *laid_.front().map : fuseMaps(laid_, 0, options_.fusion).merged,
        options_.features);
  }

  const BendOptions& options_;
  std::vector<PlacedMap> laid_;
  MapFeatures features_;
};

BentMap layOn(const MapFeatures& ground, const PlacedMap& placed, const MapFeatures& features,
              const Map& reference, const BendOptions& options) {
  const RigidTransform transform = placedOn(ground, features, placed.pose_in_reference);
  const DriftField drift = estimateDrift(ground, features, transform, options.drift);
  const EvidenceWeights weights(options.evidence);
  const Evidence as_placed = gatherEvidence(ground, features, transform, kAllPoints, weights);
  const Evidence when_bent =
      gatherEvidence(ground, features, transform, drift, kAllPoints, weights);
  BentMap result;
  if (!(when_bent.agree > as_placed.agree && when_bent.conflict <= as_placed.conflict)) {
    result.map = *placed.map;
    result.map.corner_in_map = placed.pose_in_reference + placed.map->corner_in_map;
    return result;
  }
  const Pose2D& grid = ground.grid_in_map;
  const RigidTransform from_ground{grid.phi, {grid.x, grid.y}};
  const PointMover to_ground(from_ground.inverse()), back(from_ground);
  const Displacement displacement = [&](const Point2D& point) {
    const Eigen::Vector2d moved = back.turn(drift.at(to_ground({point.x, point.y})));
    return Point2D(moved.x(), moved.y());
  };
  const BentLattice lattice{reference.corner_in_map,
                            std::min(reference.resolution(), placed.map->resolution()),
                            options.fusion.max_cells, options.fusion.threads};
  result.map = bendMap(placed, displacement, largestShift(drift), lattice);
  result.is_bent = true;
  result.shift = meanShift(drift, features, transform);
  return result;
}

}  // namespace

std::vector<BentMap> bendMaps(const std::vector<PlacedMap>& maps, size_t reference,
                              const BendOptions& options) {
  std::vector<MapFeatures> features(maps.size());
  parallelFor(static_cast<int>(maps.size()), options.fusion.threads, [&](int i) {
    const auto k = static_cast<size_t>(i);
    features[k] = extractFeatures(*maps[k].map, options.features);
  });
  std::vector<BentMap> bent(maps.size());
  bent[reference].map = *maps[reference].map;
  Ground ground(options, bent[reference].map);
  std::vector<size_t> left;
  for (size_t i = 0; i < maps.size(); ++i) {
    if (i != reference) {
      left.push_back(i);
    }
  }
  while (!left.empty()) {
    const auto shared = [&](size_t i) {
      return gatherEvidence(ground.features(), features[i],
                            placedOn(ground.features(), features[i], maps[i].pose_in_reference))
          .free_free;
    };
    auto next = left.begin();
    double most = shared(*next);
    for (auto candidate = left.begin() + 1; candidate != left.end(); ++candidate) {
      const double area = shared(*candidate);
      if (area > most || (area == most && comesFirst(features[*candidate], features[*next]))) {
        next = candidate;
        most = area;
      }
    }
    const size_t index = *next;
    left.erase(next);
    bent[index] =
        layOn(ground.features(), maps[index], features[index], *maps[reference].map, options);
    ground.add(bent[index].map);
  }
  return bent;
}

}  // namespace sbox
