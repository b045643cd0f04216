// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From scans with poses to a grid: MRPT's own log-odds mapping of every observation that its grids
// understand (2D lidar scans, sonar).
#pragma once

#include <string>

#include "sbox/core/key_frame.h"
#include "sbox/core/map.h"

namespace sbox {

/// How scans become cells.
struct MappingOptions {
  double resolution = 0.05;  ///< Edge length of a cell, in metres.
  double max_range = 15;     ///< How far a beam changes cells, in metres.
  double certainty = 0.65;   ///< Probability that one beam says of a cell, in (0.5, 1).
  double max_tilt = 0.035;   ///< A lidar tilted more out of the plane is left out, in radians.
};

/// The map of all that was seen, cropped to the cells it knows.
/// Throws std::invalid_argument if no observation could be used, a pose or an observation is not
/// sound (see isSound()) or an option makes no sense, and std::length_error if the poses lie so far
/// apart that the map would be too large.
[[nodiscard]] Map mapKeyFrames(const std::string& name, const KeyFrames& key_frames,
                               const MappingOptions& options = {});

}  // namespace sbox
