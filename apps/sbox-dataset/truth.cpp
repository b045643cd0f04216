// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/truth.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sbox/core/rigid_fit.h"
#include "sbox/core/state_grid.h"

namespace sbox::dataset {
namespace {

/// A scan point in the world, and the step that saw it.
struct Sighting {
  Point2D point_in_world;
  const RunStep* step = nullptr;
};

using VoxelKey = std::pair<long, long>;

VoxelKey voxelOf(const Point2D& point, double edge) {
  return {std::lround(point.x / edge), std::lround(point.y / edge)};
}

/// The first sighting in each square of `edge` metres of the world.
std::map<VoxelKey, Sighting> sightings(const Run& run, double edge) {
  std::map<VoxelKey, Sighting> result;
  for (const RunStep& step : run) {
    const auto beams = step.scan.getScanSize();
    for (size_t i = 0; i < beams; ++i) {
      if (!step.scan.getScanRangeValidity(i)) {
        continue;
      }
      const double angle = step.scan.getScanAngle(i);
      const double range = static_cast<double>(step.scan.getScanRange(i));
      const mrpt::math::TPoint3D point_in_robot = step.scan.sensorPose.asTPose().composePoint(
          {range * std::cos(angle), range * std::sin(angle), 0});
      const Point2D point_in_world =
          step.pose_in_world.composePoint({point_in_robot.x, point_in_robot.y});
      result.emplace(voxelOf(point_in_world, edge), Sighting{point_in_world, &step});
    }
  }
  return result;
}

/// Where the map of the robot that made `step` has a point of the world.
Point2D placeInMap(const RunStep& step, const Point2D& point_in_world) {
  return step.pose_in_map.composePoint(step.pose_in_world.inverseComposePoint(point_in_world));
}

/// At most `count` elements, evenly spread over the list.
template <typename T>
std::vector<T> thinned(const std::vector<T>& all, size_t count) {
  std::vector<T> result;
  for (size_t i = 0; i < std::min(count, all.size()); ++i) {
    result.push_back(all[i * all.size() / std::min(count, all.size())]);
  }
  return result;
}

/// Fills in the rigid transform that fits the places best, and what it leaves of them.
void fitPlaces(PairTruth& truth) {
  std::vector<Point2D> all_in_a, all_in_b;
  for (const auto& [in_a, in_b] : truth.places) {
    all_in_a.push_back(in_a);
    all_in_b.push_back(in_b);
  }
  truth.pose_b_in_a = fitRigid(all_in_b, all_in_a);
  double sum = 0;
  for (const auto& [in_a, in_b] : truth.places) {
    sum += (truth.pose_b_in_a.composePoint(in_b) - in_a).sqrNorm();
  }
  truth.rms = std::sqrt(sum / static_cast<double>(truth.places.size()));
}

double overlapOf(const Map& map_a, const Map& map_b, const Pose2D& pose_b_in_a) {
  const StateGrid a = classifyCells(map_a), b = classifyCells(map_b);
  const Pose2D corner_b_in_a = pose_b_in_a + b.corner_in_map;
  int known_b = 0, common = 0;
  for (int y = 0; y < b.height; ++y) {
    for (int x = 0; x < b.width; ++x) {
      if (b.at(x, y) == CellState::Unknown) {
        continue;
      }
      ++known_b;
      const Point2D centre_in_a =
          corner_b_in_a.composePoint({(x + 0.5) * b.resolution, (y + 0.5) * b.resolution});
      const Point2D in_grid = a.corner_in_map.inverseComposePoint(centre_in_a);
      const int ax = static_cast<int>(std::floor(in_grid.x / a.resolution));
      const int ay = static_cast<int>(std::floor(in_grid.y / a.resolution));
      common += a.at(ax, ay) == CellState::Unknown ? 0 : 1;
    }
  }
  const auto known_a =
      static_cast<int>(a.cells.size()) -
      static_cast<int>(std::count(a.cells.begin(), a.cells.end(), CellState::Unknown));
  return static_cast<double>(common) / std::max(1, std::min(known_a, known_b));
}

}  // namespace

std::optional<PairTruth> findTruth(const Run& run_a, const Run& run_b, const Map& map_a,
                                   const Map& map_b, const TruthOptions& options) {
  const auto seen_by_b = sightings(run_b, options.radius);
  std::map<VoxelKey, std::pair<Point2D, Point2D>> spread;
  for (const auto& [voxel, by_a] : sightings(run_a, options.radius)) {
    const auto by_b = seen_by_b.find(voxel);
    if (by_b != seen_by_b.end()) {
      const Point2D& place = by_a.point_in_world;
      spread.emplace(
          voxelOf(place, options.spacing),
          std::pair{placeInMap(*by_a.step, place), placeInMap(*by_b->second.step, place)});
    }
  }
  PairTruth truth;
  for (const auto& entry : spread) {
    truth.places.push_back(entry.second);
  }
  truth.places = thinned(truth.places, options.count);
  if (truth.places.size() < 2) {
    return std::nullopt;
  }
  fitPlaces(truth);
  truth.overlap = overlapOf(map_a, map_b, truth.pose_b_in_a);
  return truth;
}

}  // namespace sbox::dataset
