// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/fleet.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "sbox-dataset/drive.h"
#include "sbox-dataset/office.h"
#include "sbox-dataset/ranger.h"
#include "sbox-dataset/route.h"
#include "sbox-dataset/world_grid.h"

namespace sbox::dataset {
namespace {

constexpr double kCell = 0.05;  ///< Of the grids that robots plan in and see, metres.

/// A way through neighbouring rooms, half to nearly all of them; without points if furniture
/// encloses the start.
Path drawTour(const RoutePlanner& planner, std::vector<Point2D> places, std::mt19937& random) {
  std::sort(places.begin(), places.end(), [](const Point2D& left, const Point2D& right) {
    return std::pair(left.x, left.y) < std::pair(right.x, right.y);
  });
  const double share = std::uniform_real_distribution<double>(0.5, 0.9)(random);
  const double from = std::uniform_real_distribution<double>(0, 1 - share)(random);
  const auto count = static_cast<double>(places.size());
  const auto first = places.begin() + static_cast<std::ptrdiff_t>(from * count);
  const auto last = places.begin() + static_cast<std::ptrdiff_t>((from + share) * count);
  std::vector<Point2D> visited(first, last);
  const double heading = std::uniform_real_distribution<double>(-M_PI, M_PI)(random);
  const Pose2D start(visited.front().x, visited.front().y, heading);
  visited.erase(visited.begin());
  return planner.tour(start, visited);
}

/// A tour that leads somewhere.
Path randomTour(const RoutePlanner& planner, const std::vector<Point2D>& places,
                std::mt19937& random) {
  constexpr int most_draws = 100;
  for (int draw = 0; draw < most_draws; ++draw) {
    Path path = drawTour(planner, places, random);
    if (!path.points_in_world.empty()) {
      return path;
    }
  }
  throw std::runtime_error("an office has no room that a robot can leave");
}

}  // namespace

std::vector<NamedRun> driveFleet(const FleetOptions& options) {
  std::vector<NamedRun> fleet;
  for (int building = 0; building < options.buildings; ++building) {
    const std::uint32_t seed = options.seed * 10007U + static_cast<std::uint32_t>(building);
    OfficeOptions office;
    office.furniture_per_m2 *= options.furniture;
    const World world = randomOffice(seed, office);
    const mrpt::maps::COccupancyGridMap2D grid = worldGrid(world, kCell);
    const RoutePlanner planner(grid);
    std::mt19937 random(seed);
    const std::string place = "b" + std::to_string(building);
    for (int robot = 0; robot < options.robots; ++robot) {
      DriveOptions drive_options;
      drive_options.seed = static_cast<std::uint32_t>(random());
      drive_options.odometry_sigma *= options.drift;
      drive_options.heading_sigma *= options.drift;
      const Path path = randomTour(planner, world.places, random);
      fleet.push_back({place + "r" + std::to_string(robot), place,
                       drive(gridRanger(grid), path, drive_options)});
    }
  }
  return fleet;
}

}  // namespace sbox::dataset
