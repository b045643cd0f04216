// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/robot_pair.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "sbox-dataset/office.h"
#include "sbox-dataset/route.h"
#include "sbox-dataset/world_grid.h"
#include "sbox-paper/slam.h"

namespace sbox::paper {
namespace {

using dataset::Path;
using dataset::RoutePlanner;
using dataset::World;

constexpr double kPlanningCell = 0.05;
constexpr double kScanCell = 0.02;

/// A tour of the places that starts at the first of them from which most others can be reached.
Path tourOf(const RoutePlanner& planner, const std::vector<Point2D>& places, double heading) {
  Path longest;
  for (const Point2D& start : places) {
    Path path = planner.tour({start.x, start.y, heading}, places);
    if (path.points_in_world.size() > longest.points_in_world.size()) {
      longest = std::move(path);
    }
    if (longest.points_in_world.size() >= places.size()) {
      break;
    }
  }
  return longest;
}

}  // namespace

dataset::DriveOptions robotOptions(std::uint32_t seed) {
  dataset::DriveOptions options;
  options.step_length = 0.25;
  options.step_angle = 20 * M_PI / 180;
  options.odometry_sigma = 0.01;
  options.heading_sigma = 0.1 * M_PI / 180;
  options.seed = seed;
  return options;
}

RobotPair simulatePair(const std::string& name, World world, const std::array<Path, 2>& paths,
                       Slam slam, std::uint32_t seed) {
  RobotPair pair;
  pair.name = name;
  const RoutePlanner planner(worldGrid(world, kPlanningCell));
  const auto scan_grid = worldGrid(world, kScanCell);
  for (size_t i = 0; i < 2; ++i) {
    const Path planned = planner.tour(paths[i].start_in_world, paths[i].points_in_world);
    dataset::DriveOptions options = robotOptions(seed + static_cast<std::uint32_t>(i));
    if (slam == Slam::None) {
      options.heading_sigma = 0.03 * M_PI / 180;
    }
    pair.runs[i] = drive(dataset::gridRanger(scan_grid), planned, options);
    if (slam == Slam::Icp) {
      pair.runs[i] = slamByIcp(pair.runs[i]);
    } else if (slam == Slam::Rbpf) {
      pair.runs[i] = slamByRbpf(pair.runs[i], options.seed);
    }
    pair.maps[i] = mapRun(name + (i == 0 ? "_a" : "_b"), pair.runs[i]);
  }
  pair.truth = findTruth(pair.runs[0], pair.runs[1], pair.maps[0], pair.maps[1]);
  pair.world = std::move(world);
  return pair;
}

RobotPair simulateWorld(const std::string& folder, const std::string& name, Slam slam,
                        std::uint32_t seed) {
  const std::string stem = folder + "/" + name;
  return simulatePair(name, dataset::loadWorld(stem + ".world"),
                      {dataset::loadPath(stem + "_a.path"), dataset::loadPath(stem + "_b.path")},
                      slam, seed);
}

RobotPair simulateOffice(std::uint32_t office, std::uint32_t run, std::uint32_t seed, Slam slam) {
  World world = dataset::randomOffice(office);
  std::seed_seq seeds{office, run, seed};
  std::mt19937 random(seeds);
  std::vector<Point2D> places = world.places;
  std::sort(places.begin(), places.end(), [](const Point2D& a, const Point2D& b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  });
  const RoutePlanner planner(worldGrid(world, kPlanningCell));
  std::array<Path, 2> paths;
  for (Path& path : paths) {
    const double share = std::uniform_real_distribution<double>(0.55, 0.85)(random);
    const double heading = std::uniform_real_distribution<double>(-M_PI, M_PI)(random);
    const auto visited =
        static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(places.size())));
    path = tourOf(planner, {places.begin(), places.begin() + visited}, heading);
    std::reverse(places.begin(), places.end());
  }
  return simulatePair("office " + std::to_string(office) + " run " + std::to_string(run),
                      std::move(world), paths, slam, static_cast<std::uint32_t>(random()));
}

PairError errorOf(const Pose2D& pose_b_in_a, const dataset::PairTruth& truth) {
  double sum = 0;
  for (const auto& [in_a, in_b] : truth.places) {
    sum += (pose_b_in_a.composePoint(in_b) - in_a).sqrNorm();
  }
  PairError error;
  error.excess = std::sqrt(sum / static_cast<double>(truth.places.size())) - truth.rms;
  error.rotation_deg = std::abs(wrapAngle(pose_b_in_a.phi - truth.pose_b_in_a.phi)) * 180 / M_PI;
  error.right = error.excess <= 0.3 && error.rotation_deg <= 2;
  return error;
}

Pose2D worldInMap(const dataset::Run& run, const Point2D& point_in_world) {
  const auto distance = [&](const dataset::RunStep& step) {
    return std::hypot(step.pose_in_world.x - point_in_world.x,
                      step.pose_in_world.y - point_in_world.y);
  };
  const auto nearest = std::min_element(
      run.begin(), run.end(), [&](const dataset::RunStep& one, const dataset::RunStep& other) {
        return distance(one) < distance(other);
      });
  return nearest->pose_in_map + inverse(nearest->pose_in_world);
}

}  // namespace sbox::paper
