// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Robots in many buildings, for maps of which most have nothing in common.
#pragma once

#include <cstdint>
#include <vector>

#include "sbox-dataset/run.h"

namespace sbox::dataset {

struct FleetOptions {
  int buildings = 10;    ///< Random offices.
  int robots = 5;        ///< In each; every one visits half to nearly all rooms along the corridor.
  double drift = 1;      ///< Odometry noise as a multiple of DriveOptions' own.
  double furniture = 1;  ///< As a multiple of OfficeOptions' own.
  std::uint32_t seed = 1;  ///< Of offices, ways and noise.
};

/// Drives all robots: those of the first building first. Maps are called "b0r0", "b0r1", ... and
/// places "b0", ... Throws std::runtime_error if furniture bars all ways in an office.
[[nodiscard]] std::vector<NamedRun> driveFleet(const FleetOptions& options);

}  // namespace sbox::dataset
