// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Many small maps: a fleet of robots in many buildings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sbox/core/pose.h"

namespace sbox::scale {

/// What one robot mapped.
struct FleetMap {
  std::string file;        ///< Name of the .gridmap in the fleet's folder.
  int building = 0;        ///< Where it was.
  Pose2D map_in_building;  ///< Its frame.
};

/// Sends five simulated robots into each of maps / 5 random offices, where each visits the rooms of
/// some part, and writes their maps into the folder.
[[nodiscard]] std::vector<FleetMap> makeFleet(int maps, const std::filesystem::path& folder);

/// Prints what the columns of measureFleet() are.
void printFleetHeader();

/// Merges the maps in one call and prints a row; `arguments` go to the command.
void measureFleet(const std::string& command, const std::vector<FleetMap>& fleet,
                  const std::filesystem::path& folder, const std::vector<std::string>& arguments);

}  // namespace sbox::scale
