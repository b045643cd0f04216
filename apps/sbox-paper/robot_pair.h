// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two simulated robots in one world: what they did, the maps they made, and the truth about both.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "sbox-dataset/drive.h"
#include "sbox-dataset/truth.h"
#include "sbox-dataset/world.h"

namespace sbox::paper {

enum class Slam {
  None,  ///< Odometry alone, of a robot that drifts as little as others do with SLAM: for tests.
  Icp,   ///< MRPT's ICP-SLAM.
  Rbpf   ///< MRPT's RBPF-SLAM, Gmapping's algorithm; some ten times slower.
};

struct RobotPair {
  std::string name;
  dataset::World world;
  std::array<dataset::Run, 2> runs;         ///< pose_in_map by the SLAM.
  std::array<Map, 2> maps;                  ///< Made at those poses.
  std::optional<dataset::PairTruth> truth;  ///< None if they saw nothing in common.
};

/// The robots of all experiments: a 270 degree lidar of 8 m range with a noise of 0.01 m, a scan
/// each 0.25 m or 20 degrees, odometry that is off by 1 % of the way and 0.1 degrees a step.
[[nodiscard]] dataset::DriveOptions robotOptions(std::uint32_t seed);

/// Sends two robots along planned ways between the points of their paths. The second robot's noise
/// has the seed `seed + 1`.
[[nodiscard]] RobotPair simulatePair(const std::string& name, dataset::World world,
                                     const std::array<dataset::Path, 2>& paths, Slam slam,
                                     std::uint32_t seed);

/// The same for FOLDER/NAME.world, NAME_a.path and NAME_b.path. Throws std::runtime_error if one of
/// them cannot be read.
[[nodiscard]] RobotPair simulateWorld(const std::string& folder, const std::string& name, Slam slam,
                                      std::uint32_t seed);

/// Two robots that visit the rooms of a random office, one from the left, one from the right, each
/// 55 to 85 % of them; `run` decides how many and where the robots head at first.
[[nodiscard]] RobotPair simulateOffice(std::uint32_t office, std::uint32_t run, std::uint32_t seed,
                                       Slam slam = Slam::Icp);

/// How far an answer is from the truth.
struct PairError {
  double excess = 0;  ///< RMS distance of the common places less the best rigid fit's, metres.
  double rotation_deg = 0;  ///< From the best rigid fit, >= 0.
  bool right = false;       ///< At most 0.3 m and 2 degrees.
};

[[nodiscard]] PairError errorOf(const Pose2D& pose_b_in_a, const dataset::PairTruth& truth);

/// The pose of the world in the map that a run made, as it is near a point of the world: maps are
/// bent, so it varies.
[[nodiscard]] Pose2D worldInMap(const dataset::Run& run, const Point2D& point_in_world);

}  // namespace sbox::paper
