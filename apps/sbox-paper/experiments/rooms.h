// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Section 4.1: figure 8 (double walls), Table 2 and figure 11 (wall lengths) on simulated robots.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sbox-paper/coincidence.h"
#include "sbox-paper/robot_pair.h"
#include "sbox/core/pair_result.h"

namespace sbox::paper {

struct RoomsOptions {
  std::string worlds;      ///< Folder of rooms.world.
  std::uint32_t seed = 1;  ///< Of the first pair of robots; each pair has its own.
  int rbpf_pairs = 1;      ///< Pairs of maps by RBPF-SLAM, the paper's choice.
  int icp_pairs = 5;       ///< Pairs of maps by ICP-SLAM.
  int angles = 36;         ///< Random angles in (0, 360) degrees.
  int threads = 0;         ///< 0: one a core.
};

/// The double walls under one transform.
struct NamedCoincidence {
  std::string name;
  std::optional<Coincidence> coincidence;  ///< None if there is no such transform.
};

/// The measured length of one wall.
struct WallLengths {
  double truth = 0;
  std::optional<double> map_1;
  std::optional<double> map_2;   ///< Map 2 turned by the angle.
  std::optional<double> merged;  ///< None also if the maps were not merged.
};

/// All walls with map 2 turned by one angle.
struct TurnedLengths {
  double angle_deg = 0;
  Verdict verdict = Verdict::Rejected;
  std::vector<WallLengths> walls;
};

/// Mean over the walls of |length - truth| / truth; none if a wall was not measured or none is
/// there.
[[nodiscard]] std::optional<double> meanError(const std::vector<WallLengths>& walls,
                                              std::optional<double> WallLengths::*map);

struct RoomsPair {
  Slam slam = Slam::Icp;
  std::uint32_t seed = 0;
  RobotPair robots;
  PairResult answer;  ///< By the default method.
  PairError error;    ///< Of the answer.
  std::vector<NamedCoincidence> coincidences;
  std::vector<TurnedLengths> right_angles;   ///< 0, 45 and 90 degrees: Table 2.
  std::vector<TurnedLengths> random_angles;  ///< By angle: figure 11.
  /// After all scans were adjusted together; none if the maps were not matched.
  std::optional<RobotPair> adjusted;
  std::vector<WallLengths> adjusted_walls;  ///< In its maps; merged: in the map of all scans.
};

/// The pairs by RBPF-SLAM first.
[[nodiscard]] std::vector<RoomsPair> runRooms(const RoomsOptions& options);

/// The double walls of a pair under the paper's transforms, ours and the best rigid one.
[[nodiscard]] std::vector<NamedCoincidence> compareCoincidence(const RobotPair& robots,
                                                               const PairResult& answer);

/// The walls' lengths with map 2 turned by an angle, the merged map by the default method.
[[nodiscard]] TurnedLengths measureTurned(const RobotPair& robots, double angle_deg);

}  // namespace sbox::paper
