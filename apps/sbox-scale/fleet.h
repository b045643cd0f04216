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
  std::string file;     ///< Name of the .gridmap in the fleet's folder.
  std::string place;    ///< The building it was in.
  Pose2D map_in_place;  ///< Its frame.
};

/// The maps of so many simulated robots, five to a random office (sbox-dataset/fleet.h), written
/// into the folder.
[[nodiscard]] std::vector<FleetMap> makeFleet(int maps, const std::filesystem::path& folder);

/// Prints what the columns of measureFleet() are.
void printFleetHeader();

/// Merges the maps in one call and prints a row; `arguments` go to the command.
void measureFleet(const std::string& command, const std::vector<FleetMap>& fleet,
                  const std::filesystem::path& folder, const std::vector<std::string>& arguments);

}  // namespace sbox::scale
