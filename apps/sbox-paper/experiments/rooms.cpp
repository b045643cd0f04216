// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/experiments/rooms.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "sbox-bench/method_list.h"
#include "sbox-paper/adjusted_pair.h"
#include "sbox-paper/answers.h"
#include "sbox-paper/wall_length.h"
#include "sbox/core/parallel.h"

namespace sbox::paper {
namespace {

LineSegment carried(const Pose2D& pose, const LineSegment& segment) {
  return {pose.composePoint(segment.from), pose.composePoint(segment.to)};
}

/// The world's yardsticks in three maps. `frame_2` has the frame of the second run's map in that of
/// `grid_2`; an empty grid has no lengths.
std::vector<WallLengths> measureWalls(const RobotPair& robots, const Pose2D& frame_2,
                                      const StateGrid& grid_1, const StateGrid& grid_2,
                                      const StateGrid& merged) {
  std::vector<WallLengths> walls;
  for (const LineSegment& yardstick : robots.world.yardsticks) {
    const Point2D middle = (yardstick.from + yardstick.to) * 0.5;
    const LineSegment in_1 = carried(worldInMap(robots.runs[0], middle), yardstick);
    const LineSegment in_2 = carried(frame_2 + worldInMap(robots.runs[1], middle), yardstick);
    WallLengths& wall = walls.emplace_back();
    wall.truth = (yardstick.to - yardstick.from).norm();
    wall.map_1 = wallLength(grid_1, in_1);
    wall.map_2 = wallLength(grid_2, in_2);
    if (!merged.empty()) {
      wall.merged = wallLength(merged, in_1);
    }
  }
  return walls;
}

/// Adds what becomes of the pair when all scans are adjusted together.
void measureFromScans(RoomsPair& pair) {
  NamedCoincidence& entry = pair.coincidences.emplace_back();
  entry.name = "ours, from all scans";
  if (!pair.answer.has_pose) {
    return;
  }
  const RobotPair& adjusted =
      pair.adjusted.emplace(adjustedPair(pair.robots, pair.answer.pose_b_in_a));
  entry.coincidence = wallCoincidence(adjusted, Pose2D());
  pair.adjusted_walls =
      measureWalls(adjusted, Pose2D(), classifyCells(adjusted.maps[0]),
                   classifyCells(adjusted.maps[1]), classifyCells(mapOfBoth(adjusted)));
}

void measure(RoomsPair& pair, const std::vector<double>& angles_deg) {
  pair.answer = solve(defaultMethod(), pair.robots.maps[0], pair.robots.maps[1]);
  if (pair.robots.truth && pair.answer.has_pose) {
    pair.error = errorOf(pair.answer.pose_b_in_a, *pair.robots.truth);
  }
  pair.coincidences = compareCoincidence(pair.robots, pair.answer);
  measureFromScans(pair);
  for (const double angle : {0.0, 45.0, 90.0}) {
    pair.right_angles.push_back(measureTurned(pair.robots, angle));
  }
  for (const double angle : angles_deg) {
    pair.random_angles.push_back(measureTurned(pair.robots, angle));
  }
}

}  // namespace

std::optional<double> meanError(const std::vector<WallLengths>& walls,
                                std::optional<double> WallLengths::*map) {
  if (walls.empty()) {
    return std::nullopt;
  }
  double sum = 0;
  for (const WallLengths& wall : walls) {
    if (!(wall.*map)) {
      return std::nullopt;
    }
    sum += std::abs(*(wall.*map) - wall.truth) / wall.truth;
  }
  return sum / static_cast<double>(walls.size());
}

std::vector<NamedCoincidence> compareCoincidence(const RobotPair& robots,
                                                 const PairResult& answer) {
  std::vector<NamedCoincidence> result;
  const auto add = [&](const std::string& name, const std::optional<Pose2D>& pose_b_in_a) {
    NamedCoincidence& entry = result.emplace_back();
    entry.name = name;
    if (pose_b_in_a) {
      entry.coincidence = wallCoincidence(robots, *pose_b_in_a);
    }
  };
  const Map &a = robots.maps[0], &b = robots.maps[1];
  const PairResult paper = solve(bench::methodByName("paper"), a, b);
  add("paper, plain merge", plainPaperPose(a, b));
  add("paper, Kalman", paper.kalman);
  add("ours, Kalman", answer.kalman);
  add("ours, Ceres", answer.ceres);
  add("ours, reported", answer.has_pose ? std::optional<Pose2D>(answer.pose_b_in_a) : std::nullopt);
  add("best rigid fit to the truth",
      robots.truth ? std::optional<Pose2D>(robots.truth->pose_b_in_a) : std::nullopt);
  return result;
}

TurnedLengths measureTurned(const RobotPair& robots, double angle_deg) {
  const double angle = angle_deg * M_PI / 180;
  const Map& map_1 = robots.maps[0];
  const Map map_2 = turnedMap(robots.maps[1], angle);
  const PairResult answer = solve(defaultMethod(), map_1, map_2);
  TurnedLengths result;
  result.angle_deg = angle_deg;
  result.verdict = answer.verdict;
  const StateGrid grid_1 = classifyCells(map_1), grid_2 = classifyCells(map_2);
  const StateGrid merged = answer.verdict == Verdict::Accepted
                               ? classifyCells(mergeTwo(map_1, map_2, answer.pose_b_in_a))
                               : StateGrid();
  result.walls = measureWalls(robots, Pose2D(0, 0, angle), grid_1, grid_2, merged);
  return result;
}

std::vector<RoomsPair> runRooms(const RoomsOptions& options) {
  std::mt19937 random(options.seed);
  std::vector<double> angles;
  for (int i = 0; i < options.angles; ++i) {
    angles.push_back(std::uniform_real_distribution<double>(0, 360)(random));
  }
  std::sort(angles.begin(), angles.end());
  std::vector<RoomsPair> pairs(static_cast<size_t>(options.rbpf_pairs + options.icp_pairs));
  for (size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].slam = i < static_cast<size_t>(options.rbpf_pairs) ? Slam::Rbpf : Slam::Icp;
    pairs[i].seed = options.seed + 10 * static_cast<std::uint32_t>(i);
  }
  // RBPF-SLAM draws from one generator for all threads.
  for (RoomsPair& pair : pairs) {
    if (pair.slam == Slam::Rbpf) {
      pair.robots = simulateWorld(options.worlds, "rooms", pair.slam, pair.seed);
    }
  }
  parallelFor(static_cast<int>(pairs.size()), options.threads, [&](int i) {
    RoomsPair& pair = pairs[static_cast<size_t>(i)];
    if (pair.slam == Slam::Icp) {
      pair.robots = simulateWorld(options.worlds, "rooms", pair.slam, pair.seed);
    }
    measure(pair, angles);
  });
  return pairs;
}

}  // namespace sbox::paper
