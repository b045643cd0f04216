// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/drive.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "sbox-dataset/text_lines.h"

namespace sbox::dataset {
namespace {

using Random = std::mt19937;

double gaussian(Random& random, double sigma) {
  return std::normal_distribution<double>(0, sigma)(random);
}

mrpt::obs::CObservation2DRangeScan scanFrom(const Pose2D& pose_in_world, const Ranger& ranger,
                                            const DriveOptions& options, Random& random) {
  const auto beams = static_cast<size_t>(options.beams);
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(options.field_of_view);
  scan.maxRange = static_cast<float>(options.max_range);
  scan.stdError = static_cast<float>(options.range_sigma);
  scan.rightToLeft = true;
  scan.resizeScan(beams);
  ranger(pose_in_world, scan);
  for (size_t i = 0; i < beams; ++i) {
    const double noise = gaussian(random, options.range_sigma);
    if (!scan.getScanRangeValidity(i)) {
      continue;
    }
    const double range = static_cast<double>(scan.getScanRange(i)) + noise;
    const bool seen = range > 0 && range < options.max_range;
    scan.setScanRange(i, seen ? static_cast<float>(range) : scan.maxRange);
    scan.setScanRangeValidity(i, seen);
  }
  return scan;
}

/// The steps, each in the frame of the robot before it, that make up a path.
std::vector<Pose2D> stepsAlong(const Path& path, const DriveOptions& options) {
  std::vector<Pose2D> steps;
  Pose2D at = path.start_in_world;
  for (const Point2D& goal : path.points_in_world) {
    const double heading = std::atan2(goal.y - at.y, goal.x - at.x);
    const double turn = wrapAngle(heading - at.phi),
                 length = std::hypot(goal.x - at.x, goal.y - at.y);
    const int turns = static_cast<int>(std::ceil(std::abs(turn) / options.step_angle));
    const int moves = static_cast<int>(std::ceil(length / options.step_length));
    steps.insert(steps.end(), static_cast<size_t>(turns), Pose2D(0, 0, turn / std::max(turns, 1)));
    steps.insert(steps.end(), static_cast<size_t>(moves),
                 Pose2D(length / std::max(moves, 1), 0, 0));
    at = {goal.x, goal.y, heading};
  }
  return steps;
}

}  // namespace

Path loadPath(const std::string& path) {
  Path result;
  bool started = false;
  for (const TextLine& line : readTextLines(path)) {
    const std::vector<double>& n = line.numbers;
    if (!started) {
      line.expect(line.keyword == "start" && n.size() == 3, "start x y heading_deg");
      result.start_in_world = {n[0], n[1], n[2] * M_PI / 180};
      started = true;
    } else {
      line.expect(line.keyword == "to" && n.size() == 2, "to x y");
      result.points_in_world.emplace_back(n[0], n[1]);
    }
  }
  if (!started) {
    throw std::runtime_error(path + ": no line \"start x y heading_deg\"");
  }
  return result;
}

Run drive(const World& world, const Path& path, const DriveOptions& options) {
  return drive(exactRanger(world), path, options);
}

Run drive(const Ranger& ranger, const Path& path, const DriveOptions& options) {
  Random random(options.seed);
  Run run;
  Pose2D pose_in_world = path.start_in_world, pose_in_map;
  const auto look = [&] {
    run.push_back({pose_in_world, pose_in_map, scanFrom(pose_in_world, ranger, options, random)});
  };
  look();
  for (const Pose2D& step : stepsAlong(path, options)) {
    pose_in_world = pose_in_world + step;
    pose_in_map = pose_in_map + Pose2D(step.x + gaussian(random, options.odometry_sigma * step.x),
                                       0, step.phi + gaussian(random, options.heading_sigma));
    look();
  }
  return run;
}

}  // namespace sbox::dataset
